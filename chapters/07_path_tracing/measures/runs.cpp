#include "measures/runs.h"

#include <cmath>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "image/picture_error.h"
#include "integrator/near_lamps.h"
#include "integrator/render.h"
#include "measures/measured_scenes.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr int width = 32;       // of the measured pictures
constexpr int repetitions = 4;  // with the same seeds for a draft, so that its points are the report's first ones

// One method on one scene: its picture looked at after 1, 2, 4 … samples, several times anew.
struct Run {
    const MeasuredScene* scene;
    Method method;
    ConvergencePoints points;
    std::int64_t bad = 0;
};

// Enters one picture's errors, squared, and its times.
void measureOnce(Run& run, const Scene& scene, const Image& reference, std::int64_t mostSamples, std::uint64_t seed) {
    const std::vector<bool> leftOut = pixelsNearLamps(scene, 2);
    const IndependentSampler sampler(seed);
    const BoxFilter filter;
    const auto integrator = makeIntegrator(run.method, scene, sampler, filter, run.scene->mostSegments);
    std::size_t next = 0;
    const auto look = [&](const Rendering& soFar) {
        if (soFar.passes < std::int64_t{1} << next) return true;
        if (next == run.points.size()) run.points.push_back({run.scene->name, run.method, soFar.passes});
        const Real error = rmse(soFar.film.image(), reference, leftOut);
        run.points[next].seconds += soFar.seconds;
        run.points[next].error += error * error;
        ++next;
        return true;
    };
    const Rendering rendering = caustic::render(*integrator, {.passes = mostSamples, .look = look});
    run.bad += rendering.film.badSamples();
}

void measure(Run& run, const Image& reference, std::int64_t mostSamples, std::uint64_t seed) {
    const Scene scene(run.scene->make(width));
    for (int i = 0; i < repetitions; ++i)
        measureOnce(run, scene, reference, mostSamples, seed + static_cast<std::uint64_t>(i));
    for (ConvergencePoint& point : run.points) {
        point.seconds /= repetitions;
        point.error = std::sqrt(point.error / repetitions);
    }
}

}  // namespace

const ConvergencePoints& ChapterRuns::convergence(FigureContext& context) {
    if (convergence_) return *convergence_;
    const auto& scenes = measuredScenes();
    const std::int64_t mostSamples = context.byQuality(8, 256);
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
        measure(runs[at], references[at / allMethods.size()], mostSamples, context.seed() + 1000 * at);
        context.progress().advance();
    });
    convergence_.emplace();
    for (const Run& run : runs) {
        convergence_->insert(convergence_->end(), run.points.begin(), run.points.end());
        samples_ += width * width * mostSamples * repetitions;
        bad_ += run.bad;
    }
    return *convergence_;
}

}  // namespace caustic
