#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "closed_form_scenes.h"
#include "core/random.h"
#include "integrator/ray_tracer.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/stratified_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/form_factor.h"
#include "texture/checker_texture.h"

namespace caustic {
namespace {

using namespace test;

constexpr Real pi = std::numbers::pi;

// Nested media. A drink of higher index reaches 1 mm into its glass; without its priority there would be a gap of
// glass.
SceneObject slab(Real from, Real to, Real ior, const Color& sigmaA, int priority) {
    SceneObject one = pane(1, 0, ior, sigmaA);
    one.shape = std::make_shared<Box>(Vec3(from, -50, -50), Vec3(to, 50, 50));
    one.interior->priority = priority;
    return one;
}

TEST(NestedMedia, TheHigherPriorityFillsTheOverlap) {
    const Color red(0, 2, 3);
    const Color green(5, 0, 1);
    for (const int drinksPriority : {-1, 1}) {
        const Scene scene({.objects = {slab(0, 1, 1.5, red, 0), slab(0.7, 3, 1.3, green, drinksPriority)},
                           .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
        const Real border = drinksPriority > 0 ? 0.7 : 1;
        const Color expected = (-red * border - green * (3 - border)).exp();
        for (const Real side : {1.0, -1.0}) {
            const Color seen = radiance(scene, {Vec3(side > 0 ? -1 : 4, 0, 0), Vec3(side, 0, 0)});
            EXPECT_LE((seen - expected).abs().maxCoeff(), 1e-10) << "from side " << side;
        }
        // Aslant: the direction in each medium by Snell's law from the one before; the hidden boundary bends nothing.
        const Real sine = std::sin(0.8);
        const Color aslant = (-red * border / std::sqrt(1 - sine * sine / 2.25) -
                              green * (3 - border) / std::sqrt(1 - sine * sine / 1.69))
                                 .exp();
        const Color seen = radiance(scene, {Vec3(-1, 0, 0), Vec3(std::cos(0.8), sine, 0)});
        EXPECT_LE((seen - aslant).abs().maxCoeff(), 1e-10);
    }
}

TEST(NestedMedia, APointKnowsWhatItIsIn) {
    const Scene scene({.objects = {slab(0, 2, 1.5, Color::Zero(), 0), slab(1, 3, 1.3, Color::Zero(), 1)}});
    EXPECT_EQ(scene.mediaAt({-1, 0, 0}).object(), noObject);
    EXPECT_EQ(scene.mediaAt({0.5, 0, 0}).object(), 0);
    EXPECT_EQ(scene.mediaAt({1.5, 0, 0}).object(), 1);
    EXPECT_TRUE(scene.mediaAt({1.5, 0, 0}).contains(0));
    EXPECT_EQ(scene.mediaAt({2.5, 0, 0}).object(), 1);
    EXPECT_FALSE(scene.mediaAt({2.5, 0, 0}).contains(0));
}

// A camera in absorbing glass sees e^(−σ d) of what comes in; radiance within is n² times that outside.
TEST(NestedMedia, CameraInsideGlass) {
    SceneDescription description = {.objects = {pane(2, 0, 1.5, Color::Constant(0.7))},
                                    .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}};
    description.camera = std::make_shared<PinholeCamera>(Vec3(0.5, 0, 0), Vec3(2, 0, 0), Vec3::UnitY(), 0.5, 2, 2);
    const Scene scene(description);
    EXPECT_EQ(scene.cameraMedia().object(), 0);
    EXPECT_NEAR(radiance(scene, {Vec3(0.5, 0, 0), Vec3::UnitX()}).x(), 2.25 * std::exp(-0.7 * 1.5), 1e-12);
}

// A lamp within a tinted pane of index 1 and no surface: shadow rays pass it and are absorbed on their way.
TEST(NestedMedia, ShadowRaysAreAbsorbedInPanesWithoutSurface) {
    SceneObject tint = slab(-50, 50, 1, Color::Constant(1.5), 0);
    tint.shape = std::make_shared<Box>(Vec3(-50, 0.5, -50), Vec3(50, 1.2, 50));
    tint.material = nullptr;
    const Scene scene({.objects = {floor(1), tint},
                       .lights = {std::make_shared<PointLight>(Vec3(0, 2, 0), Color::Constant(4 * pi))}});
    EXPECT_NEAR(radiance(scene, {Vec3(0, 0.1, 0), -Vec3::UnitY()}).x(), std::exp(-1.5 * 0.7), 1e-10);
    // From above the floor is seen through the pane once more.
    EXPECT_NEAR(radiance(scene, {Vec3(0, 1.9, 0), -Vec3::UnitY()}).x(), std::exp(-2 * 1.5 * 0.7), 1e-10);
}

// Where every boundary stops it, a shadow ray need not be followed from boundary to boundary; a bubble of nothing far
// away makes the scene follow it all the same. Glass in glass of either priority, a ball that hangs in it, a floor.
TEST(NestedMedia, ShadowRaysFindTheSameFollowedOrNot) {
    const auto ball = [](const Vec3& center, Real radius, int priority) {
        SceneObject glass = pane(1, 0.1, 1.5, Color::Constant(0.5));
        glass.shape = std::make_shared<Sphere>(center, radius);
        glass.interior->priority = priority;
        return glass;
    };
    SceneObject stone = floor(0.5);
    stone.shape = std::make_shared<Sphere>(Vec3(0.3, 1, 0), 0.2);
    SceneDescription description = {.objects = {floor(0.5), ball({0, 1, 0}, 0.8, 0), ball({0.6, 1, 0}, 0.7, 1),
                                                ball({-1.5, 1, 0.4}, 0.3, 0), stone}};
    const Scene shortWay(description);
    SceneObject bubble;
    bubble.shape = std::make_shared<Sphere>(Vec3(0, 900, 0), 1.0);
    bubble.interior = Interior{};
    description.objects.push_back(bubble);
    const Scene longWay(description);

    int lit = 0;
    constexpr int rays = 20'000;
    for (int i = 0; i < rays; ++i) {
        Random random(8, {static_cast<std::uint64_t>(i)});
        const auto anywhere = [&] {
            const Real x = random.uniform(-2.5, 2.5);
            const Real y = random.uniform(-0.2, 2.5);
            return Vec3(x, y, random.uniform(-1.5, 1.5));
        };
        const Vec3 from = anywhere();
        const Ray ray = {from, anywhere() - from, 0, 1};
        RayCounts counts;
        const MediumStack media = shortWay.mediaAt(from);
        const Color passed = shortWay.transmittance(ray, media, counts);
        EXPECT_TRUE((passed == longWay.transmittance(ray, media, counts)).all()) << "ray " << i;
        lit += (passed > 0).all() ? 1 : 0;
    }
    EXPECT_GT(lit, rays / 10);
    EXPECT_LT(lit, rays * 9 / 10);
}

TEST(Scene, NeedsWhatItHas) {
    const Scene plain(
        {.objects = {floor(0.5)}, .lights = {std::make_shared<PointLight>(Vec3(0, 2, 0), Color::Ones())}});
    const SceneNeeds& few = plain.needs();
    EXPECT_TRUE(few.diffuse);
    EXPECT_FALSE(few.specular || few.glossy || few.areaLights || few.environment || few.ambient || few.lens ||
                 few.interiors || few.medium || few.textures);

    const auto checker = std::make_shared<CheckerTexture>(Color::Ones(), Color::Zero(), 1);
    SceneObject lamp;
    lamp.shape = std::make_shared<Sphere>(Vec3(0, 9, 0), 1.0);
    lamp.emission = shining(1);
    const SceneObject board = {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()),
                               .material = std::make_shared<DiffuseMaterial>(checker)};
    const Scene rich({.objects = {board, lamp, pane(1, 0.5, 1.5, Color::Ones())},
                      .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())},
                      .ambient = Color::Ones()});
    const SceneNeeds& many = rich.needs();
    EXPECT_TRUE(many.diffuse && many.specular && many.areaLights && many.environment && many.ambient &&
                many.interiors && many.medium && many.textures);
    EXPECT_EQ(rich.lights().size(), 2U);
}

// Parsimony: on a scene without glass, medium, lens and texture none of them is asked for.
TEST(Scene, WhatIsNotNeededIsNotAsked) {
    SceneDescription description = {.objects = {floor(0.5)},
                                    .lights = {std::make_shared<PointLight>(Vec3(0, 2, 0), Color::Ones())}};
    // Narrow enough for every ray to meet the floor.
    description.camera = std::make_shared<PinholeCamera>(Vec3(0, 1, 4), Vec3::Zero(), Vec3::UnitY(), 0.4, 8, 8);
    const Scene scene(description);
    RayTracer tracer(scene, independent, box, {.maxDepth = 5, .shadowSamples = 16});
    const RayCounts counts = render(tracer, {.passes = 1}).counts;
    EXPECT_EQ(counts.rays, 64);
    EXPECT_EQ(counts.shadowRays, 64) << "a point light needs one shadow ray, whatever the setting";
    EXPECT_EQ(counts.crossings, 0);
    EXPECT_EQ(counts.transmittances, 0);
    EXPECT_EQ(counts.distanceSamples, 0);
    EXPECT_EQ(counts.lensSamples, 0);
    EXPECT_EQ(counts.textureLookups, 0);
}

TEST(Render, PictureDoesNotDependOnThreads) {
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-1, 3, -1), Vec3(2, 0, 0), Vec3(0, 0, 2));
    lamp.emission = shining(5);
    SceneObject glass = pane(1, 0.2, 1.5, Color(1, 0, 0));
    glass.shape = std::make_shared<Sphere>(Vec3(0, 1, 0), 0.8);
    SceneDescription description = {.objects = {floor(0.5), lamp, glass}, .ambient = Color::Constant(0.1)};
    description.camera = std::make_shared<PinholeCamera>(Vec3(0, 2, 6), Vec3(0, 1, 0), Vec3::UnitY(), 0.6, 24, 20);
    const Scene scene(description);
    const StratifiedSampler sampler(9, 2);
    RayTracer tracer(scene, sampler, box, {.maxDepth = 4, .shadowSamples = 2});
    const Rendering one = render(tracer, {.passes = 4});
    const Rendering two = render(tracer, {.passes = 4, .threads = 2});
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 24; ++x) EXPECT_TRUE((one.film.value({x, y}) == two.film.value({x, y})).all());
    }
    EXPECT_EQ(one.counts.rays, two.counts.rays);
    EXPECT_EQ(one.counts.transmittances, two.counts.transmittances);
    EXPECT_EQ(one.film.badSamples(), 0);
}

}  // namespace
}  // namespace caustic
