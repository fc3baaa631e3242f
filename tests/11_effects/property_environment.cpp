#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/error.h"
#include "image/spherical_map.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "integrator/sppm.h"
#include "light/constant_environment.h"
#include "light/environment_map.h"
#include "material/diffuse_material.h"
#include "material/rough_conductor_material.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "sampling/sobol_sampler.h"
#include "sampling/warp.h"
#include "shape/sphere.h"
#include "support/agreement.h"
#include "support/direction_chi_square.h"
#include "support/path_mean.h"
#include "test_maps.h"

namespace caustic {
namespace {

using std::numbers::pi;
using test::sameBits;
using test::slantedAxes;
using test::uglyMap;

const IndependentSampler sampler(5);
const BoxFilter filter;

SceneObject ball(const Vec3& center, Real radius, std::shared_ptr<const Material> material) {
    return {std::make_shared<Sphere>(center, radius), std::move(material)};
}

// A glass ball, a dull one and a rough metal one on a floor, off centre.
SceneDescription threeBalls(std::shared_ptr<Light> sky, bool glass, int side) {
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, Color(0.7, 0.6, 0.4)),
                     ball({-0.8, 0.501, 0.2}, 0.5, std::make_shared<DiffuseMaterial>(Color(0.3, 0.7, 0.5))),
                     ball({0.4, 0.401, 0.5}, 0.4, std::make_shared<RoughConductorMaterial>(Metal::copper(), 0.3, 0.2))};
    if (glass) scene.objects.push_back(glassBall({0.1, 0.41, -0.7}, 0.4, 1.5));
    scene.lights = {std::move(sky)};
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0.6, 1.8, 3.4), Vec3(-0.1, 0.3, 0), Vec3::UnitY(), 0.7, side, side);
    return scene;
}

TEST(EnvironmentMap, DirectionsFollowTheDensity) {
    for (const auto& [width, height] : {std::pair(7, 5), {16, 8}, {1, 9}, {12, 2}}) {
        for (const Frame& axes : {Frame{}, slantedAxes()}) {
            const EnvironmentMap map(uglyMap(width, height, 3), axes);
            const test::DirectionSampling sampling = {
                [&](const Vec2& u, Real) -> std::optional<Vec3> { return map.sampleDirect({}, u)->wi; },
                [&](const Vec3& wi) { return map.pdfW(Vec3::Zero(), wi); }};
            EXPECT_GT(test::directionProbability(sampling, 100'000, 9, axes), 1e-6) << width << " x " << height;
        }
    }
}

// Each direction has the density, the radiance and the emission's density that it is picked with.
TEST(EnvironmentMap, SamplesSayWhatTheMapSays) {
    for (const Real scale : {1e-6, 1.0, 1e5}) {
        const EnvironmentMap map(uglyMap(11, 6, 4, scale), slantedAxes());
        Random random(4, {1});
        for (int i = 0; i < 5000; ++i) {
            const Vec2 u(random.uniform(), random.uniform());
            const auto sample = map.sampleDirect({}, u);
            ASSERT_NEAR(sample->pdfW / map.pdfW(Vec3::Zero(), sample->wi), 1, 1e-5);
            ASSERT_TRUE((sample->radiance == map.Le(Ray{Vec3::Zero(), sample->wi})).all());
            const auto emission = map.sampleEmission({random.uniform(), random.uniform()}, u);
            const EmissionPdf pdf = map.pdfEmission({}, emission->ray.direction);
            ASSERT_NEAR(emission->pdfW / pdf.pdfW, 1, 1e-5);
            ASSERT_EQ(emission->pdfA, pdf.pdfA);
            ASSERT_LT((emission->ray.direction + sample->wi).norm(), 1e-9) << "emission looks up the same direction";
        }
    }
}

// No sample counts more than twice the mean: the density is never much less than the radiance asks for.
TEST(EnvironmentMap, NoSampleOutshinesTwiceTheMean) {
    for (const auto& [width, height] : {std::pair(9, 3), {32, 16}, {5, 40}}) {
        const EnvironmentMap map(uglyMap(width, height, 8));
        Random random(4, {2});
        Real mean = 0;
        Real most = 0;
        constexpr int samples = 20'000;
        for (int i = 0; i < samples; ++i) {
            const auto sample = map.sampleDirect({}, {random.uniform(), random.uniform()});
            const Real weight = sample->radiance.maxCoeff() / sample->pdfW;
            mean += weight / samples;
            most = std::max(most, weight);
        }
        EXPECT_LE(most, 2.2 * mean) << width << " x " << height;
    }
}

// At the poles and at the seam nothing jumps: all directions around a pole see one radiance, and both sides of the
// seam.
TEST(EnvironmentMap, PolesAndSeamAreLikeAnyOtherPlace) {
    const EnvironmentMap map(uglyMap(16, 8, 6), Frame{});
    for (const Real z : {1.0, -1.0}) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 near(1e-9 * std::cos(0.1 * i), 1e-9 * std::sin(0.1 * i), z);
            const Real pdf = map.pdfW(Vec3::Zero(), near.normalized());
            ASSERT_TRUE(std::isfinite(pdf));
            if (map.Le(Ray{Vec3::Zero(), near}).maxCoeff() > 0) {
                ASSERT_GT(pdf, 0);
            }
        }
        ASSERT_TRUE(std::isfinite(map.pdfW(Vec3::Zero(), Vec3(0, 0, z))));
    }
    for (int i = 1; i < 100; ++i) {
        const Real theta = pi * i / 100;
        const Vec3 left(-std::sin(theta), 1e-10, std::cos(theta));
        const Vec3 right(-std::sin(theta), -1e-10, std::cos(theta));
        ASSERT_NEAR(map.pdfW(Vec3::Zero(), left), map.pdfW(Vec3::Zero(), right), 1e-6);
        ASSERT_LT((map.Le(Ray{Vec3::Zero(), left}) - map.Le(Ray{Vec3::Zero(), right})).abs().maxCoeff(), 1e-6);
    }
}

// A sun of one pixel in the dark, wherever it stands: each sample finds it, and together they have its irradiance. The
// look-up spreads it bilinearly: ∫ L dω is L times the pixel's width times the share of its row.
TEST(EnvironmentMap, EachSampleFindsTheSun) {
    for (const auto& [x, y] : {std::pair(0, 11), {511, 128}, {200, 0}, {37, 255}, {300, 60}}) {
        Image sky(512, 256);
        sky.set(x, y, Color(3e6, 2e6, 1e6));
        const EnvironmentMap map(sky);
        Random random(4, {3});
        Color sum = Color::Zero();
        constexpr int samples = 4000;
        for (int i = 0; i < samples; ++i) {
            const auto sample = map.sampleDirect({}, {random.uniform(), random.uniform()});
            ASSERT_GT(sample->radiance.x(), 0);
            ASSERT_NEAR(sample->radiance.x() / sample->radiance.z(), 3, 1e-6);
            sum += sample->radiance / (sample->pdfW * samples);
        }
        EXPECT_LT((sum / (4 * pi * map.mean()) - 1).abs().maxCoeff(), 0.02) << x << ", " << y;
    }
}

// The mean over all directions is that of the look-up, by midpoints in (angle, z).
TEST(EnvironmentMap, MeanIsThatOfTheLookup) {
    for (const auto& [width, height] : {std::pair(7, 5), {4, 1}, {5, 2}, {9, 3}}) {
        const Image image = uglyMap(width, height, 12);
        Color sum = Color::Zero();
        constexpr int perAxis = 1200;
        for (int i = 0; i < perAxis * perAxis; ++i) {
            const Real z = -1 + 2 * (i / perAxis + 0.5) / perAxis;
            const Real angle = 2 * pi * (i % perAxis + 0.5) / perAxis;
            const Real sine = std::sqrt(1 - z * z);
            sum += lookUpSpherical(image, Vec3(sine * std::cos(angle), sine * std::sin(angle), z));
        }
        const Color truth = sum / (Real(perAxis) * perAxis);
        EXPECT_LT((EnvironmentMap(image).mean() / truth - 1).abs().maxCoeff(), 1e-3) << width << " x " << height;
    }
}

// A convex diffuse body in even light shows ρ L all over.
TEST(EnvironmentMap, EvenLightOnADiffuseBall) {
    const Real radiance = 1.7;
    const Image even(8, 4, Color::Constant(radiance));
    SceneDescription description;
    description.objects = {ball({0.3, -0.2, 0.1}, 0.7, std::make_shared<DiffuseMaterial>(Color::Constant(0.6)))};
    description.lights = {std::make_shared<EnvironmentMap>(even, slantedAxes())};
    description.camera =
        std::make_shared<PinholeCamera>(Vec3(4, 1, 2), Vec3(0.3, -0.2, 0.1), Vec3::UnitZ(), 0.05, 1, 1);
    const Scene scene(description);
    const PathTracer paths(scene, sampler, filter, {});
    const PathTracer lights(scene, sampler, filter, {.direct = Direct::DirectLight});
    const BidirectionalPathTracer both(scene, sampler, filter, {});
    const Real truth = 0.6 * even.at(0, 0).x();
    for (const Integrator* method : std::initializer_list<const Integrator*>{&paths, &lights, &both}) {
        const test::PathMean found = test::meanOfRounds(*method, 1, 2e-3);
        EXPECT_NEAR(found.mean, truth, 5 * found.standardError + 1e-12);
    }
}

// One colour: bit for bit the picture of a constant environment, whatever the method.
TEST(EnvironmentMap, OneColourIsAConstantEnvironment) {
    const Color color(0.75, 0.5, 1.25);
    const Scene constant(threeBalls(std::make_shared<ConstantEnvironment>(color), true, 24));
    const Scene mapped(threeBalls(environmentLight(Image(16, 8, color), slantedAxes()), true, 24));
    const auto same = [&](auto make) {
        const auto first = make(constant);
        const auto second = make(mapped);
        return sameBits(developed(*first, render(*first, {.passes = 2, .threads = 2})),
                        developed(*second, render(*second, {.passes = 2})));
    };
    EXPECT_TRUE(same(
        [](const Scene& scene) { return std::make_unique<PathTracer>(scene, sampler, filter, PathTracerSettings{}); }));
    EXPECT_TRUE(same([](const Scene& scene) {
        return std::make_unique<BidirectionalPathTracer>(scene, sampler, filter, PathLimits{});
    }));
    EXPECT_TRUE(same([](const Scene& scene) {
        return std::make_unique<Sppm>(scene, sampler, filter, SppmSettings{.photons = 1000});
    }));
}

// Path tracing, light tracing and bidirectional path tracing, under a map of a few bright pixels.
TEST(EnvironmentMap, MethodsAgree) {
    const auto scene =
        threeBalls(std::make_shared<EnvironmentMap>(uglyMap(24, 12, 2), slantedAxes()), false, test::agreementSide);
    const test::Agreement agreement = test::compareMethods({{"map", scene, false}}, test::agreementMethods(), 48, 1, 2);
    EXPECT_TRUE(agreement.agrees()) << agreement.worst << ": " << agreement.largestT << " of " << agreement.mostT
                                    << ", means " << agreement.largestMeanT << ", variance " << agreement.variance;
    EXPECT_LE(agreement.largestError, 0.05);
}

// The same share of light over direct samples of the map and over uniform ones, whose variance is at least twenty times
// as large when a small sun has most of the light.
TEST(EnvironmentMap, BrightnessIsWorthTwentyTimesTheSamples) {
    Image sky(128, 64, Color(0.2, 0.3, 0.5));
    sky.set(90, 14, Color(9000, 8000, 7000));
    const EnvironmentMap map(sky);
    const Vec3 normal = Vec3(0.2, 0.1, 1).normalized();
    Random random(4, {4});
    constexpr int samples = 400'000;
    Real sums[2] = {0, 0};
    Real squares[2] = {0, 0};
    for (int i = 0; i < samples; ++i) {
        const Vec2 u(random.uniform(), random.uniform());
        const auto chosen = map.sampleDirect({}, u);
        const Vec3 even = uniformSphere(u);
        const Real values[2] = {chosen->radiance.y() * std::max(Real(0), chosen->wi.dot(normal)) / chosen->pdfW,
                                map.Le(Ray{Vec3::Zero(), even}).y() * std::max(Real(0), even.dot(normal)) * 4 * pi};
        for (int k = 0; k < 2; ++k) {
            sums[k] += values[k] / samples;
            squares[k] += values[k] * values[k] / samples;
        }
    }
    const Real variances[2] = {squares[0] - sums[0] * sums[0], squares[1] - sums[1] * sums[1]};
    EXPECT_NEAR(sums[0], sums[1], 6 * std::sqrt(variances[1] / samples));
    EXPECT_GT(variances[1] / variances[0], 20);
}

TEST(EnvironmentMap, RefusesWhatIsNoLight) {
    EXPECT_THROW(EnvironmentMap(Image(4, 2)), InputError) << "all black";
    Image negative(4, 2, Color::Ones());
    negative.set(1, 1, Color(0.2, -1e-6, 0.3));
    EXPECT_THROW(EnvironmentMap{negative}, InputError);
    EXPECT_THROW(environmentLight(Image(4, 2, Color(-1, 0, 0))), InputError);
    negative.set(1, 1, Color(0.2, std::nan(""), 0.3));
    EXPECT_THROW(EnvironmentMap{negative}, InputError);
    EXPECT_EQ(environmentLight(Image(4, 2))->power().maxCoeff(), 0) << "a dark one is a constant environment";
}

}  // namespace
}  // namespace caustic
