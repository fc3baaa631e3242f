#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "closed_form_scenes.h"
#include "integrator/ray_tracer.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/mirror_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/stratified_sampler.h"
#include "shape/box.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/form_factor.h"
#include "texture/checker_texture.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

using namespace test;

constexpr Real pi = std::numbers::pi;

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

}  // namespace
}  // namespace caustic
