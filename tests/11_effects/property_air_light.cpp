#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "core/error.h"
#include "core/random.h"
#include "curve/gauss_legendre.h"
#include "integrator/medium_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/sphere.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

struct AirLight {
    Color sigmaA;
    Color sigmaS;
    Real g = 0;
    Vec3 lamp;
    Color intensity;
    Real size;  // radius of the ball of fog around everything

    Scene scene() const {
        SceneDescription description;
        description.objects = {
            {.shape = std::make_shared<Sphere>(Vec3::Zero(), size),
             .interior = Interior{
                 1, std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<HenyeyGreenstein>(g)), 0}}};
        description.lights = {std::make_shared<PointLight>(lamp, intensity)};
        return Scene(std::move(description));
    }

    // The air-light integral ∫ σ_s p I e^(−σ_t (t + d)) / d² dt over angles seen from the lamp, in which the integrand
    // is smooth (Sun et al. 2005, A Practical Analytic Single Scattering Model for Real Time Rendering, eq. 8 and 10):
    // Gauss's rule of 32 points on each of 64 pieces.
    Color integral(const Ray& ray, Real tEnd) const {
        const Real foot = (lamp - ray.origin).dot(ray.direction);
        const Real beside = (lamp - ray.at(foot)).norm();
        const Real from = std::atan(-foot / beside);
        const Real to = std::atan((tEnd - foot) / beside);
        const GaussRule rule = gaussLegendreRule(32);
        constexpr int pieces = 64;
        Color sum = Color::Zero();
        for (int piece = 0; piece < pieces; ++piece) {
            const Real half = (to - from) / (2 * pieces);
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const Real angle = from + half * (2 * piece + 1 + rule.nodes[i]);
                const Real t = foot + beside * std::tan(angle);
                const Real d = beside / std::cos(angle);
                const Vec3 wi = (lamp - ray.at(t)).normalized();
                sum += rule.weights[i] * half / beside * sigmaS * HenyeyGreenstein(g).p(-ray.direction, wi) *
                       intensity * (-(sigmaA + sigmaS) * (t + d)).exp();
            }
        }
        return sum;
    }
};

MediumSpan along(const Scene& scene, const Ray& ray) {
    std::vector<MediumSpan> spans;
    MediumStack media = scene.mediaAt(ray.origin);
    Color passed;
    RayCounts counts;
    scene.follow(ray, media, passed, spans, counts);
    EXPECT_EQ(spans.size(), 1U);
    return spans.front();
}

std::vector<AirLight> cases() {
    return {{{0.1, 0, 0.3}, {0.2, 0.5, 0.1}, 0, {0.3, 0.2, -0.4}, {3, 2, 1}, 5},
            {{0, 0, 0}, {0.02, 0.01, 0.05}, 0.8, {0.3, 0.2, -0.4}, {3, 2, 1}, 5},
            {{1, 2, 0.5}, {3, 1, 2}, -0.5, {-0.1, 0.4, 0.2}, {1, 4, 2}, 2},
            {{2e-5, 0, 1e-5}, {1e-4, 5e-5, 2e-4}, 0.3, {900, -400, 300}, {1e6, 2e6, 3e6}, 5000},
            {{100, 50, 0}, {300, 100, 500}, -0.2, {1e-3, -2e-3, 5e-4}, {1e-3, 2e-3, 1e-3}, 0.01}};
}

// Single scattering around a point light against its integral, channel by channel, within 1 % and five standard errors:
// past the lamp, closely past it, towards it and away from it; from within the fog, coloured, at three scales.
TEST(AirLight, EquiAngularMeetsTheIntegral) {
    constexpr int n = 60'000;
    const IndependentSampler sampler(3);
    for (const AirLight& one : cases()) {
        const Scene scene = one.scene();
        const LightChoice lights(scene.lights());
        const Vec3 eye = Vec3(-0.4, 0.5, 0.1) * one.size;
        for (const Real miss : {0.3, 0.03, 1e-3}) {
            const Vec3 aim = one.lamp + miss * one.size * Vec3(0.1, 0.5, 0.8);
            for (const Real way : {1.0, -1.0}) {
                const Ray ray = {eye, way * (aim - eye).normalized()};
                const MediumSpan span = along(scene, ray);
                Color sum = Color::Zero();
                Color squares = Color::Zero();
                RayCounts counts;
                for (int i = 0; i < n; ++i) {
                    const Color value =
                        scatteredEquiAngular(scene, lights, span, 1, 0, sampler.start(1, {0, 0}, i), counts);
                    sum += value;
                    squares += value * value;
                }
                const Color mean = sum / n;
                const Color error = ((squares / n - mean * mean).max(0) / n).sqrt();
                const Color expected = one.integral(ray, span.tEnd);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_NEAR(mean[c], expected[c], 5.5 * error[c] + 1e-9 * expected[c]) << miss << ", " << way;
                    EXPECT_NEAR(mean[c], expected[c], 0.01 * expected[c]) << miss << ", " << way;
                }
                EXPECT_EQ(counts.rays, 0) << "Nothing is done but shadow rays.";
            }
        }
    }
}

// The glow that photons can't show: as the ray passes nearer to the lamp, the light grows as one over the distance.
TEST(AirLight, GlowsAroundTheLamp) {
    const AirLight one = cases()[0];
    const Scene scene = one.scene();
    const LightChoice lights(scene.lights());
    const IndependentSampler sampler(4);
    const Vec3 eye(-2, 1, 0);
    Color before = Color::Zero();
    for (const Real miss : {0.1, 0.01, 0.001}) {
        const Vec3 across = (one.lamp - eye).cross(Vec3::UnitZ()).normalized();
        const MediumSpan span = along(scene, {eye, (one.lamp + miss * across - eye).normalized()});
        Color mean = Color::Zero();
        RayCounts counts;
        for (int i = 0; i < 4000; ++i)
            mean += scatteredEquiAngular(scene, lights, span, 1, 0, sampler.start(1, {0, 0}, i), counts) / 4000;
        if (before.maxCoeff() > 0) {
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / before[c], 10.5, 1) << miss;
        }
        before = mean;
    }
}

// Marching comes to the integral with many steps, and is blind to what lies between few of them.
TEST(AirLight, MarchingNeedsStepsAsNarrowAsTheGlow) {
    const AirLight one = cases()[0];
    const Scene scene = one.scene();
    const LightChoice lights(scene.lights());
    const IndependentSampler sampler(4);
    const Vec3 eye(-2, 1, 0);
    const MediumSpan span = along(scene, {eye, (one.lamp + Vec3(0.002, 0.005, 0) - eye).normalized()});
    const Color expected = one.integral(span.ray, span.tEnd);
    const auto marched = [&](int steps) {
        RayCounts counts;
        return scatteredByMarching(scene, lights, span, steps, 0, sampler.start(1, {0, 0}, 0), counts);
    };
    EXPECT_LE((marched(100'000) / expected - 1).abs().maxCoeff(), 1e-4);
    EXPECT_GE((marched(16) / expected - 1).abs().maxCoeff(), 0.3);
}

// Light from infinitely far away has no place to look around: places are picked as the medium does. All that isn't
// absorbed of an even sky is scattered to the eye once: σ_s/σ_t (1 − T) of what passes to there.
TEST(AirLight, TakesSkyLightAtPlacesOfTheMedium) {
    AirLight one = cases()[0];
    one.size = 1e-3;  // so thin that nothing is lost on the way in
    SceneDescription description;
    description.objects = {
        {.shape = std::make_shared<Sphere>(Vec3::Zero(), one.size),
         .interior = Interior{
             1, std::make_shared<HomogeneousMedium>(one.sigmaA, one.sigmaS, std::make_shared<HenyeyGreenstein>(0.3)),
             0}}};
    description.lights = {std::make_shared<ConstantEnvironment>(Color(1, 2, 3))};
    const Scene scene(description);
    const LightChoice lights(scene.lights());
    const MediumSpan span = along(scene, {Vec3(-5, 0, 0), Vec3::UnitX()});
    const IndependentSampler sampler(5);
    constexpr int n = 2'000'000;
    Color mean = Color::Zero();
    RayCounts counts;
    for (int i = 0; i < n; ++i)
        mean += scatteredEquiAngular(scene, lights, span, 1, 0, sampler.start(1, {0, 0}, i), counts) / n;
    const Color expected = one.sigmaS * 2e-3 * Color(1, 2, 3);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / expected[c], 1, 0.2) << c;
}

// A half-space has no end: equi-angular sampling reaches there, steps don't.
TEST(AirLight, ReachesToInfinity) {
    const AirLight one = cases()[0];
    const Scene scene = one.scene();
    const LightChoice lights(scene.lights());
    MediumSpan span = along(scene, {Vec3(-2, 1, 0), Vec3(0.6, 0, 0.8)});
    span.tEnd = std::numeric_limits<Real>::infinity();
    const IndependentSampler sampler(6);
    RayCounts counts;
    for (int i = 0; i < 1000; ++i)
        EXPECT_TRUE(scatteredEquiAngular(scene, lights, span, 1, 0, sampler.start(1, {0, 0}, i), counts).allFinite());
    EXPECT_THROW(scatteredByMarching(scene, lights, span, 8, 0, sampler.start(1, {0, 0}, 0), counts), InputError);
}

}  // namespace
}  // namespace caustic
