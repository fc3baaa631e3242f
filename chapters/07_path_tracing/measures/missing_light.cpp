#include "measures/missing_light.h"

#include <numbers>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "integrator/picture.h"
#include "integrator/walk.h"
#include "light/point_light.h"
#include "modeler/caustic_scene.h"
#include "sampling/independent_sampler.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"

namespace caustic {

namespace {

constexpr int width = 80;
constexpr int height = 60;
constexpr int mostSegments = 16;
constexpr Real lampRadius = 0.08;
constexpr Real intensity = 10;  // W/sr

// The scene without its lamp.
SceneDescription dark(Vec3& lampPlace) {
    const CausticScene caustic;
    SceneDescription scene = caustic.beforeMirror(width, height);
    std::erase_if(scene.objects, [](const SceneObject& one) { return one.emission != nullptr; });
    lampPlace = caustic.lamp;
    return scene;
}

SceneDescription underPoint() {
    Vec3 place;
    SceneDescription scene = dark(place);
    scene.lights = {std::make_shared<PointLight>(place, Color::Constant(intensity))};
    return scene;
}

SceneDescription underBall() {
    Vec3 place;
    SceneDescription scene = dark(place);
    const Real radiance = intensity / (std::numbers::pi * lampRadius * lampRadius);
    scene.objects.push_back({.shape = std::make_shared<Sphere>(place, lampRadius),
                             .emission = std::make_shared<ConstantTexture>(Color::Constant(radiance))});
    return scene;
}

// Sees a lamp, straight or over delta lobes, and nothing else.
struct LampSeen {
    Color sum = Color::Zero();

    bool reached(const Interaction& at, const WalkState& path) {
        if (at.light() != nullptr) sum += path.beta * at.Le();
        return !at.connectible();
    }
    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState&) {}
};

// Mean of the lamp's own image over all pixels.
Real lampImage(const Scene& scene, const Sampler& sampler, std::int64_t samples, int threads) {
    std::vector<Real> rows(height, 0);
    parallelFor(height, threads, [&](std::int64_t y) {
        RayCounts counts;
        for (std::int64_t i = 0; i < width * samples; ++i) {
            const PathNumbers numbers = sampler.start(2, {static_cast<int>(i % width), static_cast<int>(y)}, i / width);
            const Vec2 film =
                Vec2(static_cast<Real>(i % width), static_cast<Real>(y)) + numbers.pair(Dimension::film());
            LampSeen seen;
            walk(scene, {scene.camera().sampleRay(film, {0.5, 0.5}), scene.cameraMedia(), Color::Ones()},
                 TransportMode::Radiance, {.maxLength = mostSegments}, numbers, counts, seen);
            rows[static_cast<std::size_t>(y)] += seen.sum.x();
        }
    });
    Real sum = 0;
    for (const Real row : rows) sum += row;
    return sum / static_cast<Real>(width * height * samples);
}

Real meanOf(const Image& picture) {
    Real sum = 0;
    for (int i = 0; i < width * height; ++i) sum += picture.at(i % width, i / width).x();
    return sum / (width * height);
}

}  // namespace

std::vector<MissingLight> missingLight(std::int64_t samples, FigureContext& context) {
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    const auto light = [&](Method method, const Scene& scene, std::int64_t paths) {
        const auto integrator = makeIntegrator(method, scene, sampler, filter, mostSegments);
        return meanOf(renderImage(*integrator, paths, context));
    };
    const Scene ball(underBall());
    const Real all = light(Method::Bidirectional, ball, samples) - lampImage(ball, sampler, samples, context.threads());
    const Scene point(underPoint());
    std::vector<MissingLight> missing;
    for (const Method method : {Method::Chance, Method::Direct, Method::Mis, Method::Light, Method::Bidirectional})
        missing.push_back({method, 100 * (1 - light(method, point, samples / 4) / all)});
    return missing;
}

}  // namespace caustic
