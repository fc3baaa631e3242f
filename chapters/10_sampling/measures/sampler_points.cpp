#include "measures/sampler_points.h"

#include <cmath>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "measures/lit_floor.h"
#include "modeler/caustic_scene.h"
#include "sampling/sampler_names.h"

namespace caustic {

namespace {

constexpr int width = 32;

// A scene, its truth, how it is rendered.
struct Measured {
    std::string name;
    const Scene* scene;
    Image truth;
    PathTracerSettings settings;
    std::vector<std::int64_t> samples;
    std::uint64_t seeds;
};

// Each pixel the mean of the block that it takes the place of.
Image shrunk(const Image& picture, int to) {
    const int block = picture.width() / to;
    Image small(to, to);
    for (int y = 0; y < to; ++y) {
        for (int x = 0; x < to; ++x) {
            Color sum = Color::Zero();
            for (int i = 0; i < block * block; ++i) sum += picture.at(x * block + i % block, y * block + i / block);
            small.set(x, y, sum / (block * block));
        }
    }
    return small;
}

SamplerPoint measured(const Measured& what, const std::string& name, std::int64_t samples, std::uint64_t seed) {
    SamplerPoint point = {what.name, name, samples, 0, 0};
    const BoxFilter filter;
    Real squares = 0;
    for (std::uint64_t i = 0; i < what.seeds; ++i) {
        const auto sampler = makeSampler(name, seed + i, samples);
        PathTracer tracer(*what.scene, *sampler, filter, what.settings);
        const Rendering rendering = render(tracer, {.passes = samples});
        requireFinite(rendering);
        point.seconds += rendering.seconds / static_cast<double>(what.seeds);
        const Real error = rmse(rendering.film.image(), what.truth);
        squares += error * error / static_cast<Real>(what.seeds);
    }
    point.error = std::sqrt(squares);
    return point;
}

}  // namespace

std::vector<SamplerPoint> samplerPoints(FigureContext& context) {
    const LitFloor floor = LitFloor::under(width);
    const Scene caustic(CausticScene{}.onFloor(width));
    const Image causticTruth = shrunk(loadImage(context.asset("assets/references/caustic_floor.exr")), width);
    std::vector<std::int64_t> few = {16, 64};
    std::vector<std::int64_t> many = {4, 16, 64, 256};
    if (context.quality() == Quality::Report) many.push_back(1024);
    if (context.quality() == Quality::Report) few.push_back(256);
    const std::vector<Measured> scenes = {
        {"smooth", &floor.scene(), floor.truth(), {{LitFloor::segments, 1}, Direct::DirectLight}, many, 2},
        {"caustic", &caustic, causticTruth, {{64, 1}, Direct::Mis}, few, 2}};
    struct Job {
        const Measured* scene;
        std::string sampler;
        std::int64_t samples;
    };
    std::vector<Job> jobs;
    for (const Measured& scene : scenes) {
        for (const std::string& name : samplerNames()) {
            for (const std::int64_t samples : scene.samples) jobs.push_back({&scene, name, samples});
        }
    }
    std::vector<SamplerPoint> points(jobs.size());
    context.progress().expect(static_cast<std::int64_t>(jobs.size()));
    parallelFor(static_cast<std::int64_t>(jobs.size()), context.threads(), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        points[at] = measured(*jobs[at].scene, jobs[at].sampler, jobs[at].samples, context.seed());
        context.progress().advance();
    });
    return points;
}

Real slopeOf(const std::vector<SamplerPoint>& points, const std::string& scene, const std::string& sampler) {
    Real count = 0;
    Vec2 sum = Vec2::Zero();
    Real xx = 0;
    Real xy = 0;
    for (const SamplerPoint& one : points) {
        if (one.scene != scene || one.sampler != sampler) continue;
        const Vec2 place(std::log(static_cast<Real>(one.samples)), std::log(one.error));
        ++count;
        sum += place;
        xx += place.x() * place.x();
        xy += place.x() * place.y();
    }
    return (xy - sum.x() * sum.y() / count) / (xx - sum.x() * sum.x() / count);
}

}  // namespace caustic
