#include "runs.h"

#include <stdexcept>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "image/picture_error.h"
#include "integrator/timed_render.h"
#include "measured_scenes.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr int width = 32;  // of the measured pictures
constexpr double noLimit = 1e9;

// One method on one scene, its picture looked at after 1, 2, 4 … samples.
struct Run {
    const MeasuredScene* scene;
    Method method;
    ConvergencePoints points;
    std::int64_t bad = 0;
};

void measure(Run& run, const Image& reference, std::int64_t mostSamples, std::uint64_t seed) {
    const Scene scene(run.scene->make(width));
    const std::vector<bool> leftOut = pixelsNearLamps(scene, 2);
    const IndependentSampler sampler(seed);
    const BoxFilter filter;
    const auto integrator = makeIntegrator(run.method, scene, sampler, filter, run.scene->mostSegments);
    std::int64_t next = 1;
    const Rendering rendering = renderFor(*integrator, noLimit, [&](const Rendering& soFar, const TimedMoment& moment) {
        if (moment.samples < next) return true;
        next *= 2;
        run.points.push_back({run.scene->name, run.method, moment.samples, moment.seconds,
                              rmse(soFar.film.image(), reference, leftOut)});
        return next <= mostSamples;
    });
    run.bad = rendering.film.badSamples();
}

}  // namespace

Rendering ChapterRuns::render(const Integrator& integrator, std::int64_t samples, FigureContext& context) const {
    Rendering rendering = caustic::render(integrator, samples, context.threads(), &context.progress());
    if (const auto& bad = rendering.film.firstBad())
        throw std::runtime_error("pixel (" + std::to_string(bad->pixel.x) + ", " + std::to_string(bad->pixel.y) +
                                 "), sample " + std::to_string(bad->index) + " is not finite");
    return rendering;
}

const ConvergencePoints& ChapterRuns::convergence(FigureContext& context) {
    if (convergence_) return *convergence_;
    const auto& scenes = measuredScenes();
    const std::int64_t mostSamples = context.byQuality(16, 512);
    std::vector<Run> runs;
    std::vector<Image> references;
    for (const MeasuredScene& scene : scenes) {
        const auto file = scene.asset.empty() ? std::filesystem::path() : context.asset(scene.asset);
        references.push_back(referenceOf(scene, width, file, context.threads()));
        for (const Method method : allMethods) runs.push_back({&scene, method, {}, 0});
    }
    context.progress().expect(static_cast<std::int64_t>(runs.size()));
    parallelFor(static_cast<std::int64_t>(runs.size()), context.threads(), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        measure(runs[at], references[at / allMethods.size()], mostSamples, context.seed() + at);
        context.progress().advance();
    });
    convergence_.emplace();
    for (const Run& run : runs) {
        convergence_->insert(convergence_->end(), run.points.begin(), run.points.end());
        samples_ += width * width * mostSamples;
        bad_ += run.bad;
    }
    return *convergence_;
}

}  // namespace caustic
