#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "support/coloured_fog.h"
#include "support/in_cube.h"
#include "support/isotropic_phase.h"
#include "support/path_mean.h"
#include "support/sphere_integral.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(11);
const BoxFilter box;

// ∫ p dω = 1 and ∫ cosθ p dω = g, at peaks of a thousandth of a radian, too.
TEST(Phase, IsNormalisedWithItsMeanCosine) {
    const Vec3 wo = Vec3(0.5, -0.3, 0.7).normalized();
    std::vector<Vec2> crowd;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 off(std::sin(2.4 * i), std::cos(2.4 * i), std::sin(0.7 * i));
        for (const Vec3& peak : {wo, Vec3(-wo)})
            crowd.push_back(test::placeOnSphere((peak + 0.02 * std::pow(0.998, i) * off).normalized()));
    }
    for (const Real g : {-0.99, -0.5, 0.0, 0.2, 0.9, 0.99}) {
        const HenyeyGreenstein phase(g);
        const auto integral = [&](const auto& integrand) { return test::sphereIntegral(integrand, {}, 1e-9, crowd); };
        EXPECT_NEAR(integral([&](const Vec3& wi) { return phase.p(wo, wi); }), 1, 1e-5) << g;
        EXPECT_NEAR(integral([&](const Vec3& wi) { return -wo.dot(wi) * phase.p(wo, wi); }), g, 1e-5) << g;
    }
}

// The value at the peak and opposite of it in closed form, and the same for both directions swapped; g = 0 is
// IsotropicPhase bit for bit.
TEST(Phase, IsExactAtTheEnds) {
    Random random(2, {});
    const Vec3 wo = Vec3(0.2, 0.9, -0.4).normalized();
    for (const Real g : {-0.99, -1e-9, 0.3, 0.99, 1 - 1e-9}) {
        const HenyeyGreenstein phase(g);
        EXPECT_NEAR(phase.p(wo, -wo) * 4 * pi * (1 - g) * (1 - g) / (1 + g), 1, 1e-9) << g;
        EXPECT_NEAR(phase.p(wo, wo) * 4 * pi * (1 + g) * (1 + g) / (1 - g), 1, 1e-9) << g;
        for (int i = 0; i < 100; ++i) {
            const Vec3 wi = test::inCube(random).normalized();
            EXPECT_EQ(phase.p(wo, wi), phase.p(wi, wo));
            EXPECT_EQ(phase.pdfW(wo, wi), phase.p(wo, wi));
            EXPECT_NEAR(HenyeyGreenstein(0).p(wo, wi), test::IsotropicPhase().p(wo, wi), 1e-16);
        }
    }
}

TEST(Phase, RefusesCosinesThatAreNone) {
    for (const Real g : {-1.0, 1.0, 1.5, std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()})
        EXPECT_THROW(HenyeyGreenstein{g}, InputError) << g;
}

std::shared_ptr<const HomogeneousMedium> fog(const Color& sigmaA, const Color& sigmaS, Real g = 0) {
    return std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<HenyeyGreenstein>(g));
}

// Over a grid of numbers, weights of scattered samples mean ∫ σ_s T dt, of passing ones T; and the density is the
// weight's: a direction of any length, a clear channel, both ends of scale, no end.
TEST(Medium, DistancesAreUnbiasedInEachChannel) {
    for (const Real scale : {1e-3, 1.0, 1e3}) {
        const Color sigmaA = Color(0.5, 0, 0.1) / scale;
        const Color sigmaS = Color(0.2, 0, 2.5) / scale;
        const auto medium = fog(sigmaA, sigmaS);
        const Color sigmaT = sigmaA + sigmaS;
        for (const Real length : {1.0, 0.2}) {
            const Ray ray = {Vec3(1, 2, 3), length * Vec3(0.6, 0.8, 0)};
            for (const Real end : {0.4 * scale, 3 * scale, std::numeric_limits<Real>::infinity()}) {
                constexpr int n = 30'000;
                Color scattered = Color::Zero();
                Color passed = Color::Zero();
                for (int i = 0; i < n; ++i) {
                    for (const Real channel : {0.1, 0.4, 0.9}) {
                        const DistanceSample one = medium->sampleDistance(ray, end / length, (i + 0.5) / n, channel);
                        (one.scattered ? scattered : passed) += one.weight / (3 * n);
                        EXPECT_EQ(one.scattered, one.t < end / length);
                        EXPECT_GT(one.pdf, 0);
                    }
                }
                for (int c = 0; c < 3; ++c) {
                    const Real T = sigmaT[c] == 0 ? 1 : std::exp(-sigmaT[c] * end);
                    const Real albedo = sigmaT[c] == 0 ? 0 : sigmaS[c] / sigmaT[c];
                    EXPECT_NEAR(passed[c], T, 2e-3) << c;
                    EXPECT_NEAR(scattered[c], albedo * (1 - T), 2e-3) << c;
                    EXPECT_NEAR(medium->transmittance(ray, end / length)[c], T, 1e-12);
                }
            }
        }
    }
}

TEST(Medium, RefusesWhatNoMediumHas) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto phase = std::make_shared<HenyeyGreenstein>(0);
    for (const Real bad : {-1e-9, nan, std::numeric_limits<Real>::infinity()}) {
        EXPECT_THROW(HomogeneousMedium(Color(0, bad, 0), Color::Zero(), phase), InputError);
        EXPECT_THROW(HomogeneousMedium(Color::Zero(), Color(0, 0, bad), phase), InputError);
    }
    EXPECT_THROW(HomogeneousMedium(Color::Zero(), Color::Zero(), nullptr), InputError);
    EXPECT_EQ(HomogeneousMedium(Color::Ones(), Color::Zero(), phase).phase(), nullptr) << "It doesn't scatter.";
}

// A room with glass and a mirror in it, and a ball of something around all of it.
SceneDescription room(std::shared_ptr<const Medium> medium, bool around) {
    SceneDescription description;
    description.objects = {diffuseRectangle({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, {0.7, 0.5, 0.3}),
                           diffuseRectangle({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, {0.3, 0.6, 0.4}),
                           glassBall({0.3, 0, -0.5}, 0.4, 1.5), mirrorBall({-0.5, 0.3, -0.6}, 0.35),
                           rectangleLamp({-0.3, -0.3, 1}, {0, 0.6, 0}, {0.6, 0, 0}, {9, 8, 7})};
    if (around)
        description.objects.push_back(
            {.shape = std::make_shared<Sphere>(Vec3(0.1, 0, 0), 3), .interior = Interior{1, std::move(medium), -1}});
    description.lights = {std::make_shared<PointLight>(Vec3(0.4, -0.4, 0.7), Color(1, 2, 1))};
    description.camera =
        std::make_shared<PinholeCamera>(Vec3(0.1, -2.5, 0.2), Vec3(0, 0, -0.2), Vec3::UnitZ(), 0.8, 24, 24);
    return description;
}

void expectSamePictures(const SceneDescription& one, const SceneDescription& other) {
    const Scene first(one);
    const Scene second(other);
    const PathLimits limits = {.maxLength = 8, .rouletteStart = 3};
    const auto compare = [](Integrator&& a, Integrator&& b) {
        const Film here = render(a, {.passes = 3}).film;
        const Film there = render(b, {.passes = 3}).film;
        for (int y = 0; y < here.height(); ++y) {
            for (int x = 0; x < here.width(); ++x)
                ASSERT_TRUE((here.value({x, y}) == there.value({x, y})).all()) << x << ", " << y;
        }
    };
    compare(PathTracer(first, sampler, box, {limits, Direct::Mis}),
            PathTracer(second, sampler, box, {limits, Direct::Mis}));
    compare(BidirectionalPathTracer(first, sampler, box, limits),
            BidirectionalPathTracer(second, sampler, box, limits));
}

// A medium of density 0 changes no bit: not beside the same ball with nothing in it, and not beside no ball at all,
// where all that is seen is within.
TEST(Medium, OfDensityZeroIsEmptySpaceBitForBit) {
    const auto nothing = fog(Color::Zero(), Color::Zero(), 0.7);
    expectSamePictures(room(nothing, true), room(nullptr, true));
    expectSamePictures(room(nothing, true), room(nullptr, false));
    EXPECT_FALSE(Scene(room(nothing, true)).needs().scattering);
    EXPECT_TRUE(Scene(room(fog(Color::Zero(), Color::Ones()), true)).needs().scattering);
}

// Beside the plainest medium that the tests know, with light turned alike into all directions.
TEST(Medium, IsTheTestsOwnFogBitForBit) {
    const Color sigmaA(0.3, 0.1, 0.7);
    const Color sigmaS(0.2, 0.9, 0.4);
    const auto medium = std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<test::IsotropicPhase>());
    expectSamePictures(room(medium, true), room(std::make_shared<test::ColouredFog>(sigmaA, sigmaS), true));
}

// A furnace stays white with light turned forwards and backwards, coloured media of albedo 1, a camera within.
TEST(Medium, WhiteFurnaceStaysWhite) {
    for (const Real g : {-0.8, 0.6, 0.95}) {
        SceneDescription description;
        description.objects = {{.shape = std::make_shared<Sphere>(Vec3::Zero(), 1),
                                .interior = Interior{1, fog(Color::Zero(), {0.4, 1.5, 3}, g), 0}},
                               {.shape = std::make_shared<Sphere>(Vec3(0.1, -0.7, 0.2), 0.25),
                                .material = std::make_shared<DielectricMaterial>(),
                                .interior = Interior{1.5, nullptr, 2}},
                               {.shape = std::make_shared<Sphere>(Vec3(-0.9, 0.1, 0), 0.3),
                                .material = std::make_shared<DiffuseMaterial>(Color::Ones())}};
        description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
        description.camera =
            std::make_shared<PinholeCamera>(Vec3(0.3, -0.4, 0.5), Vec3(-0.2, 0, 0), Vec3::UnitZ(), 0.5, 1, 1);
        const Scene scene(description);
        const PathLimits limits = {.maxLength = 4000, .rouletteStart = 1};
        const test::PathMean path =
            test::meanOfRounds(PathTracer(scene, sampler, box, {limits, Direct::Mis}), 16, 0.005);
        EXPECT_NEAR(path.mean, 1, 5 * path.standardError + 1e-9) << g;
        const test::PathMean both = test::meanOfRounds(BidirectionalPathTracer(scene, sampler, box, limits), 16, 0.01);
        EXPECT_NEAR(both.mean, 1, 5 * both.standardError) << g;
    }
}

// Chandrasekhar's H of isotropic scattering with albedo w, from its integral equation in the form that converges for
// all w: 1/H(μ) = √(1 − w) + w/2 ∫ μ' H(μ') / (μ + μ') dμ'. Radiative Transfer 1960, ch. V, eq. 12.
Real chandrasekharH(Real w, Real mu) {
    constexpr int n = 64;
    std::vector<Real> h(n, 1);
    const auto node = [&](int i) { return (i + 0.5) / n * (i + 0.5) / n; };  // denser at 0
    const auto weight = [&](int i) { return 2 * (i + 0.5) / n / n; };
    const auto inverse = [&](Real at) {
        Real sum = 0;
        for (int i = 0; i < n; ++i) sum += weight(i) * node(i) * h[static_cast<std::size_t>(i)] / (at + node(i));
        return std::sqrt(1 - w) + w / 2 * sum;
    };
    for (int round = 0; round < 200; ++round) {
        std::vector<Real> next;
        for (int i = 0; i < n; ++i) next.push_back(1 / inverse(node(i)));
        h = next;
    }
    return 1 / inverse(mu);
}

// Many times scattered light in closed form: a half-space of fog under an even sky of radiance 1 sends out
// 1 − √(1 − w) H(μ) (Kirchhoff's law for what Chandrasekhar's law of emission leaves), each channel by its own albedo.
TEST(Medium, HalfSpaceReflectsAsChandrasekharSays) {
    const Color albedo(0.9, 0.5, 0.97);
    for (int first = 0; first < 3; ++first) {
        const Color turned(albedo[first], albedo[(first + 1) % 3], albedo[(first + 2) % 3]);
        const Color sigmaT(1, 2, 0.5);
        for (const Real mu : {0.25, 0.8}) {
            SceneDescription description;
            description.objects = {
                {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitZ()),
                 .interior = Interior{1,
                                      std::make_shared<HomogeneousMedium>(sigmaT * (1 - turned), sigmaT * turned,
                                                                          std::make_shared<test::IsotropicPhase>()),
                                      0}}};
            description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
            const Vec3 down(std::sqrt(1 - mu * mu), 0, -mu);
            description.camera = std::make_shared<PinholeCamera>(-down, Vec3::Zero(), Vec3::UnitZ(), 1e-3, 1, 1);
            const Scene scene(description);
            const PathLimits limits = {.maxLength = 2000, .rouletteStart = 4};
            const Real expected = 1 - std::sqrt(1 - turned[0]) * chandrasekharH(turned[0], mu);
            const test::PathMean found =
                test::meanOfRounds(PathTracer(scene, sampler, box, {limits, Direct::ByChance}), 16, 0.003);
            EXPECT_NEAR(found.mean, expected, 5 * found.standardError + 1e-3) << turned[0] << ", μ = " << mu;
        }
    }
}

}  // namespace
}  // namespace caustic
