#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "integrator/ray_tracer.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

SceneObject whiteFloor() {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()),
            .material = std::make_shared<DiffuseMaterial>(Color::Ones())};
}

// Between x = 0 and x = 1. Index 1.5; it reflects `reflectance` and lets the rest pass.
SceneObject pane(Real reflectance, Real sigma) {
    SceneObject glass;
    glass.shape = std::make_shared<Box>(Vec3(0, -9, -9), Vec3(1, 9, 9));
    glass.material =
        std::make_shared<RefractionMaterial>(Color::Constant(reflectance), Color::Constant(1 - reflectance));
    glass.interior = Interior{1.5, std::make_shared<AbsorbingMedium>(Color::Constant(sigma)), 0};
    return glass;
}

std::shared_ptr<Light> pointLight() { return std::make_shared<PointLight>(Vec3(0, 2, 0), Color::Constant(4 * pi)); }

// Light that leaves a hit along the ray's way back: RayTracer::direct alone.
Real directAt(const Scene& scene, const Ray& ray, const RayTracerSettings& settings, std::int64_t index) {
    const IndependentSampler sampler(1);
    const BoxFilter box;
    const RayTracer tracer(scene, sampler, box, settings);
    MediumStack media = scene.mediaAt(ray.origin);
    Color transmittance;
    RayCounts counts;
    const auto at = scene.follow(ray, media, transmittance, counts);
    return tracer.direct(*at, 0, sampler.start(0, {0, 0}, index), counts).x();
}

Real radiance(const Scene& scene, const Ray& ray, const RayTracerSettings& settings) {
    const IndependentSampler sampler(1);
    const BoxFilter box;
    const RayTracer tracer(scene, sampler, box, settings);
    RayCounts counts;
    return tracer.Li(ray, scene.mediaAt(ray.origin), sampler.start(0, {0, 0}, 0), counts).x();
}

// Lambert: L = (ρ / π) I cos θ / d².
TEST(DirectLight, PointLightFallsWithDistanceAndCosine) {
    const Scene scene({.objects = {whiteFloor()}, .lights = {pointLight()}});
    for (const Real x : {0.0, 1.0, 7.0}) {
        const Real distance = std::sqrt(4 + x * x);
        const Real seen = directAt(scene, {Vec3(x, 1, 0), -Vec3::UnitY()}, {}, 0);
        EXPECT_NEAR(seen, 4 * (2 / distance) / (distance * distance), 1e-12)
            << "Which cosine belongs to the rendering equation, and is it there once?";
    }
}

TEST(DirectLight, ShadowIsBlack) {
    const SceneObject lid = {.shape = std::make_shared<Rectangle>(Vec3(-1, 1.5, -1), Vec3(2, 0, 0), Vec3(0, 0, 2)),
                             .material = std::make_shared<DiffuseMaterial>(Color::Ones())};
    const Scene scene({.objects = {whiteFloor(), lid}, .lights = {pointLight()}});
    EXPECT_EQ(directAt(scene, {Vec3(0.2, 1, 0), -Vec3::UnitY()}, {}, 0), 0) << "Did you ask what is in the way?";
    EXPECT_GT(directAt(scene, {Vec3(6, 1, 0), -Vec3::UnitY()}, {}, 0), 0);
}

// In a furnace of radiance 1 a white plane sends out 1, however many points of the environment are asked.
TEST(DirectLight, MoreSamplesMeanTheSameLight) {
    const Scene scene({.objects = {whiteFloor()}, .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
    for (const int samples : {1, 4, 64}) {
        Real sum = 0;
        const int n = 64'000 / samples;
        for (int i = 0; i < n; ++i)
            sum += directAt(scene, {Vec3(0, 1, 0), -Vec3::UnitY()}, {.shadowSamples = samples}, i);
        // A sample is 4 cos θ or 0: standard deviation 1.3, of the mean of 64,000 of them 0.0051; 5 of these.
        EXPECT_NEAR(sum / n, 1, 0.026) << "Is it their mean, or their sum?";
    }
}

// The lamp hangs in a tinted medium of index 1 that no surface bounds, one metre above the floor: e^(−σ) of its light
// arrives.
TEST(DirectLight, IsAbsorbedOnItsWay) {
    SceneObject fog;
    fog.shape = std::make_shared<Box>(Vec3(-9, -1, -9), Vec3(9, 9, 9));
    fog.interior = Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(0.7)), 0};
    const auto lamp = std::make_shared<PointLight>(Vec3::UnitY(), Color::Constant(pi));
    const Scene scene({.objects = {whiteFloor(), fog}, .lights = {lamp}});
    EXPECT_NEAR(directAt(scene, {Vec3(0, 0.5, 0), -Vec3::UnitY()}, {}, 0), std::exp(-0.7), 1e-10)
        << "What does the shadow ray pass through, from the point to the lamp?";
}

// Two facing mirrors that shine: the k-th reflection adds R^k, up to the depth and no further.
TEST(Recursion, MirrorCorridorIsAGeometricSeries) {
    const auto mirror = std::make_shared<MirrorMaterial>(Color::Constant(0.5));
    const auto light = std::make_shared<ConstantTexture>(Color::Ones());
    const auto left = std::make_shared<Rectangle>(Vec3(0, -1, -1), Vec3(0, 2, 0), Vec3(0, 0, 2));
    const auto right = std::make_shared<Rectangle>(Vec3(2, -1, -1), Vec3(0, 0, 2), Vec3(0, 2, 0));
    const Scene scene({.objects = {{.shape = left, .material = mirror, .emission = light},
                                   {.shape = right, .material = mirror, .emission = light}}});
    for (const int depth : {0, 1, 4}) {
        EXPECT_NEAR(radiance(scene, {Vec3(1, 0, 0), Vec3::UnitX()}, {.maxDepth = depth}), 2 - std::pow(0.5, depth),
                    1e-12)
            << "At depth " << depth << ": how many surfaces are seen, and what does each count?";
    }
}

// A pane that reflects R at both faces lets (1 − R)/(1 + R) pass when all reflections within are followed.
TEST(Recursion, EveryLobeIsFollowed) {
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(3, -9, -9), Vec3(0, 0, 18), Vec3(0, 18, 0));
    lamp.emission = std::make_shared<ConstantTexture>(Color::Ones());
    const Scene scene({.objects = {pane(0.5, 0), lamp}});
    EXPECT_NEAR(radiance(scene, {Vec3(-1, 0, 0), Vec3::UnitX()}, {.maxDepth = 100, .leastWeight = 1e-12}), 1.0 / 3,
                1e-10)
        << "Does light go on both ways at a boundary, reflected and refracted?";
}

// Through the pane: e^(−σ d); on the way before it, nothing is lost.
TEST(Recursion, AbsorbsInsideTheGlass) {
    const Scene scene({.objects = {pane(0, 0.8)}, .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
    EXPECT_NEAR(radiance(scene, {Vec3(-5, 0, 0), Vec3::UnitX()}, {}), std::exp(-0.8), 1e-12)
        << "On which side of the boundary is the medium, and does the way back count it?";
}

// From inside a medium without a boundary in sight: the way to the environment is infinite.
TEST(Recursion, LightFromBeyondIsAbsorbedToo) {
    SceneObject fog;
    fog.shape = std::make_shared<Box>(Vec3(-2, -2, -2), Vec3(2, 2, 2));
    fog.interior = Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(0.5)), 0};
    const Scene scene({.objects = {fog}, .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
    EXPECT_NEAR(radiance(scene, {Vec3::Zero(), Vec3::UnitX()}, {}), std::exp(-1), 1e-12)
        << "What passed on the way before the ray left the scene?";
}

}  // namespace
}  // namespace caustic
