#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/walk.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "sampling/independent_sampler.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/coloured_fog.h"
#include "support/path_mean.h"
#include "texture/constant_texture.h"

// Paths through a medium that scatters: no chapter so far draws one, but every vertex of a path may be a point of it.
namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(6);
const BoxFilter box;

std::shared_ptr<const Medium> fog(const Color& sigmaA, const Color& sigmaS) {
    return std::make_shared<test::ColouredFog>(sigmaA, sigmaS);
}

SceneObject ballOf(const Vec3& center, Real radius, std::shared_ptr<const Medium> medium, int priority = 0) {
    return {.shape = std::make_shared<Sphere>(center, radius), .interior = Interior{1, std::move(medium), priority}};
}

SceneObject ball(const Vec3& center, Real radius, std::shared_ptr<const Material> material) {
    return {.shape = std::make_shared<Sphere>(center, radius), .material = std::move(material)};
}

// Of one pixel.
std::shared_ptr<const Camera> look(const Vec3& from, const Vec3& at, Real fieldOfView) {
    return std::make_shared<PinholeCamera>(from, at, Vec3::UnitZ(), fieldOfView, 1, 1);
}

// A furnace of radiance 1 stays one, whatever is in it that absorbs nothing: fog of any colour and albedo 1, two fogs
// in one another, a white ball half in it, glass. A camera in the fog and one outside.
TEST(Fog, WhiteFurnaceStaysWhite) {
    for (const Vec3& eye : {Vec3(3, 0.2, 0.1), Vec3(0.3, -0.4, 0.5)}) {
        SceneDescription description;
        description.objects = {ballOf(Vec3::Zero(), 1, fog(Color::Zero(), {0.4, 1.5, 3})),
                               ballOf({0.2, 0.3, -0.1}, 0.4, fog(Color::Zero(), {2, 0.3, 1}), 1),
                               ball({-0.9, 0.1, 0}, 0.3, std::make_shared<DiffuseMaterial>(Color::Ones())),
                               {.shape = std::make_shared<Sphere>(Vec3(0.1, -0.7, 0.2), 0.25),
                                .material = std::make_shared<DielectricMaterial>(),
                                .interior = Interior{1.5, nullptr, 2}}};
        description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
        description.camera = look(eye, {-0.2, 0, 0}, 0.5);
        const Scene scene(description);
        const PathLimits limits = {.maxLength = 4000, .rouletteStart = 1};
        for (const Direct direct : {Direct::ByChance, Direct::DirectLight, Direct::Mis}) {
            const test::PathMean mean =
                test::meanOfRounds(PathTracer(scene, sampler, box, {limits, direct}), 16, 0.004);
            EXPECT_NEAR(mean.mean, 1, 5 * mean.standardError + 1e-9) << static_cast<int>(direct);
        }
        const test::PathMean mean = test::meanOfRounds(BidirectionalPathTracer(scene, sampler, box, limits), 16, 0.01);
        EXPECT_NEAR(mean.mean, 1, 5 * mean.standardError);
    }
}

// Grey fog of albedo 1 leaves no chance: every path by chance carries exactly 1, however long it gets.
TEST(Fog, EveryPathOfAGreyFurnaceCarriesOne) {
    SceneDescription description;
    description.objects = {ballOf(Vec3::Zero(), 1, fog(Color::Zero(), Color::Constant(2.5)))};
    description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
    description.camera = look({0.2, 0.5, 0.3}, Vec3::Zero(), 0.5);
    const Scene scene(description);
    const PathTracer tracer(scene, sampler, box, {{.maxLength = 100'000, .rouletteStart = 0}, Direct::ByChance});
    std::vector<Splat> splats;
    RayCounts counts;
    for (int i = 0; i < 2000; ++i)
        EXPECT_LE((tracer.tracePath({{0, 0}, i}, splats, counts) - 1).abs().maxCoeff(), 1e-9);
    EXPECT_GT(counts.distanceSamples, 4000);
}

// Counts what leaves the fog.
struct Escaping {
    Color sum = Color::Zero();
    bool reached(const Interaction&, const WalkState&) { return true; }
    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState& path) { sum += path.beta; }
};

// Energy: what a point light sends into fog that absorbs nothing comes out again, in each channel; roulette keeps the
// mean.
TEST(Fog, EnergyIsKept) {
    SceneDescription description;
    description.objects = {ballOf(Vec3::Zero(), 1, fog(Color::Zero(), {0.2, 4, 1}))};
    const Color intensity(2, 1, 0.5);
    description.lights = {std::make_shared<PointLight>(Vec3(0.3, -0.5, 0.2), intensity)};
    const Scene scene(description);
    constexpr int n = 100'000;
    Color sum = Color::Zero();
    Color squares = Color::Zero();
    RayCounts counts;
    for (int i = 0; i < n; ++i) {
        const PathNumbers numbers = sampler.start(1, {0, 0}, i);
        const auto emission = scene.lights()[0]->sampleEmission({0, 0}, numbers.pair(Dimension::emissionDirection()));
        const Color beta = emission->radiance / emission->pdfW;
        Escaping escaping;
        walk(scene, {emission->ray, scene.mediaAt(emission->ray.origin), beta}, TransportMode::Importance,
             {.maxLength = 4000, .rouletteStart = 1}, numbers, counts, escaping);
        sum += escaping.sum;
        squares += escaping.sum * escaping.sum;
    }
    const Color mean = sum / n;
    const Color error = ((squares / n - mean * mean) / n).sqrt();
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(mean[channel], 4 * pi * intensity[channel], 5.5 * error[channel]) << channel;
}

// ∫ σ_s e^(−σ_t (x + |y|)) I / (4π |y|²) dx over the way through the fog, y from the light to the point at x: light
// that is scattered once, in one channel.
Real scatteredOnce(const Ray& ray, Real enter, Real leave, const Vec3& light, Real intensity, Real sigmaS,
                   Real sigmaT) {
    constexpr int n = 20'000;
    Real sum = 0;
    for (int i = 0; i < n; ++i) {
        const Real x = enter + (i + 0.5) / n * (leave - enter);
        const Real y = (light - ray.at(x)).norm();
        sum += sigmaS * std::exp(-sigmaT * (x - enter + y)) * intensity / (4 * pi * y * y);
    }
    return sum * (leave - enter) / n;
}

// Single scattering from a point light in closed form, up to a quadrature: what a path tracer finds by sampling the
// light at a point of the fog, a light tracer by connecting such a point to the camera, a bidirectional one by both.
// Each channel comes first once; the camera stands outside the fog, off centre.
TEST(Fog, LightScatteredOnceMeetsItsIntegral) {
    const Color sigmaA(0.5, 0.1, 0);
    const Color sigmaS(0.3, 0.6, 1.4);
    const Color intensity(3, 5, 2);
    const Vec3 light(0.3, 0.35, -0.4);
    const Vec3 eye(2.5, 0.3, 0.2);
    const Vec3 target(0, -0.1, 0.15);
    const Real enterLeave = (target - eye).normalized().dot(-eye);
    const Ray ray = {eye, (target - eye).normalized()};
    const Real half = std::sqrt(1 - (eye + enterLeave * ray.direction).squaredNorm());
    for (int first = 0; first < 3; ++first) {
        const auto turned = [&](const Color& c) { return Color(c[first], c[(first + 1) % 3], c[(first + 2) % 3]); };
        SceneDescription description;
        description.objects = {ballOf(Vec3::Zero(), 1, fog(turned(sigmaA), turned(sigmaS)))};
        description.lights = {std::make_shared<PointLight>(light, turned(intensity))};
        description.camera = look(eye, target, 0.002);  // so narrow that the pixel is a single ray
        const Scene scene(description);
        const Real expected = scatteredOnce(ray, enterLeave - half, enterLeave + half, light, intensity[first],
                                            sigmaS[first], sigmaA[first] + sigmaS[first]);
        const PathLimits once = {.maxLength = 2, .rouletteStart = 9};
        const test::PathMean path =
            test::meanOfRounds(PathTracer(scene, sampler, box, {once, Direct::Mis}), 16, 0.003 * expected);
        EXPECT_NEAR(path.mean, expected, 5 * path.standardError + 1e-4 * expected) << first;
        const test::PathMean both =
            test::meanOfRounds(BidirectionalPathTracer(scene, sampler, box, once), 16, 0.003 * expected);
        EXPECT_NEAR(both.mean, expected, 5 * both.standardError + 1e-4 * expected) << first;
    }
}

// A lamp and a point light over a floor and a ball, all of it in coloured fog; the light is scattered many times. Path
// tracing, light tracing and bidirectional path tracing agree, channel by channel.
TEST(Fog, MethodsAgree) {
    const Color sigmaA(0.15, 0.02, 0.3);
    const Color sigmaS(0.4, 0.9, 0.1);
    for (int first = 0; first < 3; ++first) {
        const auto turned = [&](const Color& c) { return Color(c[first], c[(first + 1) % 3], c[(first + 2) % 3]); };
        SceneDescription description;
        SceneObject lamp;
        lamp.shape = std::make_shared<Rectangle>(Vec3(-0.5, -0.3, 1), Vec3(0, 0.6, 0), Vec3(0.6, 0, 0));
        lamp.emission = std::make_shared<ConstantTexture>(turned({4, 2, 7}));
        description.objects = {ballOf({0.1, 0, 0}, 2.2, fog(turned(sigmaA), turned(sigmaS))),
                               lamp,
                               ball({0.3, 0.2, -0.5}, 0.4, std::make_shared<DiffuseMaterial>(turned({0.8, 0.3, 0.5}))),
                               {.shape = std::make_shared<Rectangle>(Vec3(-1, -1, -0.9), Vec3(2, 0, 0), Vec3(0, 2, 0)),
                                .material = std::make_shared<DiffuseMaterial>(turned({0.6, 0.9, 0.4}))}};
        description.lights = {std::make_shared<PointLight>(Vec3(0.7, -0.6, 0.4), turned({1, 3, 2}))};
        description.camera = look({1.2, -1.6, 0.3}, {0.1, 0, -0.3}, 0.8);
        const Scene scene(description);
        const PathLimits limits = {.maxLength = 6, .rouletteStart = 2};
        const test::PathMean path =
            test::meanOfRounds(PathTracer(scene, sampler, box, {limits, Direct::Mis}), 16, 0.006);
        const IndependentSampler others(17);
        const test::PathMean both = test::meanOfRounds(BidirectionalPathTracer(scene, others, box, limits), 16, 0.006);
        const IndependentSampler more(29);
        const test::PathMean light = test::meanOfRounds(LightTracer(scene, more, box, limits), 16, 0.01);
        EXPECT_GT(path.mean, 0.05);
        EXPECT_NEAR(path.mean, both.mean, 5 * std::hypot(path.standardError, both.standardError)) << first;
        EXPECT_NEAR(path.mean, light.mean, 5 * std::hypot(path.standardError, light.standardError)) << first;
    }
}

// A path that is split into parts, each with numbers of its own, brings on average what it brings undivided.
class SplitAtFirst {
public:
    SplitAtFirst(const Scene& scene, const PathLimits& limits, const PathNumbers& numbers, int parts)
        : scene_(scene), limits_(limits), numbers_(numbers), parts_(parts) {}

    bool reached(const Interaction& at, const WalkState& path) {
        sum += path.beta * at.Le();
        if (!at.scatters() || path.length > 1) return true;
        for (int i = 0; i < parts_; ++i) {
            const PathNumbers own = numbers_.part(i, parts_);
            WalkState part = path;
            part.beta /= parts_;
            if (leaveVertex(part, at, TransportMode::Radiance, limits_, own))
                walk(scene_, part, TransportMode::Radiance, limits_, own, counts_, *this);
        }
        return false;
    }
    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState& path) { sum += path.beta * scene_.Le(path.ray); }

    Color sum = Color::Zero();

private:
    const Scene& scene_;
    const PathLimits& limits_;
    const PathNumbers& numbers_;
    int parts_;
    RayCounts counts_;
};

// Glass whose radiance scale the parts carry along, a coloured fog. With roulette from the first vertex on a part is
// worth a fifth of what the path set out with, and survives accordingly; with roulette later splitting takes noise
// away.
TEST(Walk, SplitsWithoutBias) {
    SceneDescription description;
    description.objects = {ballOf(Vec3::Zero(), 1, fog({0.2, 0.1, 0}, {0.8, 0.4, 1})),
                           ball({0.2, 0.1, -0.4}, 0.3, std::make_shared<DiffuseMaterial>(Color(0.3, 0.6, 0.2))),
                           {.shape = std::make_shared<Sphere>(Vec3(0.1, -0.5, 0.2), 0.35),
                            .material = std::make_shared<DielectricMaterial>(),
                            .interior = Interior{1.5, fog({1, 0, 0}, {0.3, 0.3, 0.3}), 2}}};
    description.lights = {std::make_shared<ConstantEnvironment>(Color(1, 0.5, 2))};
    description.camera = look({1.1, -1.4, 0.8}, Vec3::Zero(), 0.5);
    const Scene scene(description);
    constexpr int n = 40'000;
    for (const int rouletteStart : {0, 20}) {
        const PathLimits limits = {.maxLength = 200, .rouletteStart = rouletteStart};
        Color means[2];
        Color errors[2];
        for (int k = 0; k < 2; ++k) {
            Color sum = Color::Zero();
            Color squares = Color::Zero();
            for (int i = 0; i < n; ++i) {
                const PathNumbers numbers = sampler.start(static_cast<std::uint64_t>(k), {0, 0}, i);
                const Vec2 film = numbers.pair(Dimension::film());
                SplitAtFirst visitor(scene, limits, numbers, k == 0 ? 1 : 5);
                RayCounts counts;
                walk(scene, {scene.camera().sampleRay(film, {0.5, 0.5}), scene.cameraMedia(), Color::Ones()},
                     TransportMode::Radiance, limits, numbers, counts, visitor);
                sum += visitor.sum;
                squares += visitor.sum * visitor.sum;
            }
            means[k] = sum / n;
            errors[k] = ((squares / n - means[k] * means[k]) / n).sqrt();
        }
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(means[0][channel], means[1][channel], 5.5 * std::hypot(errors[0][channel], errors[1][channel]));
            if (rouletteStart > 0) {
                EXPECT_LT(errors[1][channel], errors[0][channel]) << "does splitting do anything?";
            }
        }
    }
}

}  // namespace
}  // namespace caustic
