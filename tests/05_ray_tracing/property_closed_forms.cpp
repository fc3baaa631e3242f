#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/random.h"
#include "integrator/ray_tracer.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "sampling/stratified_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/form_factor.h"
#include "texture/checker_texture.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler independent(1);
const BoxFilter box;

std::shared_ptr<const Material> diffuse(Real reflectance) {
    return std::make_shared<DiffuseMaterial>(Color::Constant(reflectance));
}

std::shared_ptr<const Texture> shining(Real radiance) {
    return std::make_shared<ConstantTexture>(Color::Constant(radiance));
}

SceneObject floor(Real reflectance) {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = diffuse(reflectance)};
}

// A pane between x = 0 and x = thickness.
SceneObject pane(Real thickness, Real reflectance, Real ior, const Color& sigmaA) {
    SceneObject glass;
    glass.shape = std::make_shared<Box>(Vec3(0, -50, -50), Vec3(thickness, 50, 50));
    glass.material =
        std::make_shared<RefractionMaterial>(Color::Constant(reflectance), Color::Constant(1 - reflectance));
    glass.interior = Interior{ior, std::make_shared<AbsorbingMedium>(sigmaA), 0};
    return glass;
}

Color radiance(const Scene& scene, const Ray& ray, const RayTracerSettings& settings = {}, RayCounts* counts = nullptr,
               const Sampler& sampler = independent, std::int64_t index = 0) {
    RayCounts own;
    const RayTracer tracer(scene, sampler, box, settings);
    return tracer.Li(ray, scene.mediaAt(ray.origin), sampler.start(0, {0, 0}, index), counts ? *counts : own);
}

// Lambert: E = I cos θ / d², L = ρ E / π.
TEST(ClosedForm, PointLightOnAPlane) {
    const Color intensity(1, 2, 5);
    const Scene scene({.objects = {floor(0.6)}, .lights = {std::make_shared<PointLight>(Vec3(0, 2, 0), intensity)}});
    for (const Real x : {0.0, 0.5, 3.0, 40.0}) {
        const Real squared = 4 + x * x;
        const Color expected = 0.6 / pi * intensity * 2 / (squared * std::sqrt(squared));
        const Color seen = radiance(scene, {Vec3(x, 1, 0), -Vec3::UnitY()});
        EXPECT_LE((seen - expected).abs().maxCoeff(), 1e-11 * expected.maxCoeff());
    }
}

// The same within the cone, nothing outside.
TEST(ClosedForm, ConeLightOnAPlane) {
    const Real halfAngle = 0.4;
    const auto cone = std::make_shared<ConeLight>(Vec3(0, 2, 0), -Vec3::UnitY(), halfAngle, Color::Constant(3));
    const Scene scene({.objects = {floor(1)}, .lights = {cone}});
    for (const Real angle : {0.0, 0.2, 0.39, 0.41, 1.0}) {
        const Real expected = angle < halfAngle ? 3 / pi * std::pow(std::cos(angle), 3) / 4 : 0;
        const Color seen = radiance(scene, {Vec3(2 * std::tan(angle), 1, 0), -Vec3::UnitY()});
        EXPECT_NEAR(seen.x(), expected, 1e-12);
    }
}

// Rectangle over a plane: E = π L F with the form factor in closed form. Standard error at most 0.1 %, 5 of them.
TEST(ClosedForm, RectanglesFormFactor) {
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));  // U × V = −y
    lamp.emission = shining(7);
    const Scene scene({.objects = {floor(0.5), lamp}});
    const StratifiedSampler stratified(1, 4);
    for (const Sampler* const sampler :
         {static_cast<const Sampler*>(&independent), static_cast<const Sampler*>(&stratified)}) {
        for (const Vec2& at : {Vec2(0, 0), Vec2(0.7, 0.3), Vec2(3, 1)}) {
            const Real factor = test::formFactor(-1 - at.x(), 1 - at.x(), -0.5 - at.y(), 0.5 - at.y(), 1.5);
            const Real expected = 0.5 * 7 * factor;
            Real sum = 0;
            Real squares = 0;
            constexpr int n = 24'000;
            for (int i = 0; i < n; ++i) {
                const Ray ray = {Vec3(at.x(), 1, at.y()), -Vec3::UnitY()};
                const Real one = radiance(scene, ray, {.shadowSamples = 16}, nullptr, *sampler, i).x();
                sum += one;
                squares += one * one;
            }
            const Real mean = sum / n;
            const Real error = std::sqrt((squares / n - mean * mean) / n);
            EXPECT_LE(error, 1e-3 * expected);
            EXPECT_NEAR(mean, expected, 5 * error);
        }
    }
    EXPECT_NEAR(radiance(scene, {Vec3(0, 1, 0), Vec3::UnitY()}).x(), 7, 1e-12) << "the lamp itself";
    EXPECT_EQ(radiance(scene, {Vec3(0, 2, 0), -Vec3::UnitY()}).x(), 0) << "its back is dark";
}

// Leaving a surface skips 2⁻⁴² of the magnitude of the way, here 1e-11 m at each face: that is what tolerances are for.

// Beer–Lambert: T = e^(−σ d) through a pane, d by Snell's law; the two scales of radiance cancel.
TEST(ClosedForm, SlabOfAbsorbingGlass) {
    const Color sigmaA(0.1, 1, 4);
    const Scene scene(
        {.objects = {pane(0.5, 0, 1.5, sigmaA)}, .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
    for (const Real angle : {0.0, 0.3, 1.0, 1.5}) {
        const Real sinInside = std::sin(angle) / 1.5;
        const Real way = 0.5 / std::sqrt(1 - sinInside * sinInside);
        const Color seen = radiance(scene, {Vec3(-1, 0, 0), Vec3(std::cos(angle), std::sin(angle), 0)});
        EXPECT_LE((seen - (-sigmaA * way).exp()).abs().maxCoeff(), 1e-10);
    }
}

// All reflections within a slab: with a = e^(−σ d), T = (1 − R)² a / (1 − R² a²) and reflected R + (1 − R)² R a² / (1 −
// R² a²). Without absorption, T = (1 − R)/(1 + R).
TEST(ClosedForm, SlabWithAllInternalReflections) {
    for (const Real R : {0.04, 0.3, 0.7}) {
        for (const Real sigma : {0.0, 1.3}) {
            // Light comes from behind only: a lamp beyond the pane.
            SceneObject lamp;
            lamp.shape =
                std::make_shared<Rectangle>(Vec3(3, -50, -50), Vec3(0, 0, 100), Vec3(0, 100, 0));  // shines to −x
            lamp.emission = shining(1);
            const Scene scene({.objects = {pane(0.5, R, 1.5, Color::Constant(sigma)), lamp}});
            const Real a = std::exp(-sigma * 0.5);
            const Real expected = (1 - R) * (1 - R) * a / (1 - R * R * a * a);
            const Real seen =
                radiance(scene, {Vec3(-1, 0, 0), Vec3::UnitX()}, {.maxDepth = 400, .leastWeight = 1e-13}).x();
            EXPECT_NEAR(seen, expected, 1e-11);
            if (sigma == 0) {
                EXPECT_NEAR(seen, (1 - R) / (1 + R), 1e-11);
            }
        }
    }
}

// Two facing mirrors that shine by themselves: depth k adds R^k: L (1 − R^(k+1))/(1 − R).
TEST(ClosedForm, MirrorCorridor) {
    const Real R = 0.8;
    const auto mirror = std::make_shared<MirrorMaterial>(Color::Constant(R));
    const auto left = std::make_shared<Rectangle>(Vec3(0, -1, -1), Vec3(0, 2, 0), Vec3(0, 0, 2));   // faces +x
    const auto right = std::make_shared<Rectangle>(Vec3(2, -1, -1), Vec3(0, 0, 2), Vec3(0, 2, 0));  // faces −x
    const Scene scene({.objects = {{.shape = left, .material = mirror, .emission = shining(3)},
                                   {.shape = right, .material = mirror, .emission = shining(3)}}});
    for (const int depth : {0, 1, 5, 30}) {
        const Real seen = radiance(scene, {Vec3(1, 0, 0), Vec3::UnitX()}, {.maxDepth = depth}).x();
        EXPECT_NEAR(seen, 3 * (1 - std::pow(R, depth + 1)) / (1 - R), 1e-11);
    }
}

// A convex diffuse body in a furnace: nothing of it is shaded, so L = ρ L_env; to the camera, the environment itself.
TEST(ClosedForm, ConvexBodyInAFurnace) {
    const SceneObject ball = {.shape = std::make_shared<Sphere>(Vec3::Zero(), 1.0), .material = diffuse(0.5)};
    const Scene scene({.objects = {ball}, .lights = {std::make_shared<ConstantEnvironment>(Color::Constant(2))}});
    Real sum = 0;
    Real squares = 0;
    constexpr int n = 1000;
    for (int i = 0; i < n; ++i) {
        const Real one =
            radiance(scene, {Vec3(0.4, 0.2, 5), -Vec3::UnitZ()}, {.shadowSamples = 64}, nullptr, independent, i).x();
        sum += one;
        squares += one * one;
    }
    const Real mean = sum / n;
    EXPECT_NEAR(mean, 1, 5 * std::sqrt((squares / n - mean * mean) / n));
    EXPECT_NEAR(radiance(scene, {Vec3(3, 0, 5), -Vec3::UnitZ()}).x(), 2, 1e-15);
}

TEST(ClosedForm, AmbientLightIsReflectedEverywhereAlike) {
    const SceneObject lid = {.shape = std::make_shared<Box>(Vec3(-5, 0.1, -5), Vec3(5, 0.2, 5)),
                             .material = diffuse(0)};
    const Scene scene({.objects = {floor(0.5), lid}, .ambient = Color(2, 3, 4)});
    const Color seen = radiance(scene, {Vec3(0, 0.05, 0), Vec3(0.1, -1, 0).normalized()});
    EXPECT_LE((seen - Color(1, 1.5, 2)).abs().maxCoeff(), 1e-14) << "under a lid too";
}

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
