#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "camera/tent_filter.h"
#include "core/random.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_start.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/phong_material.h"
#include "material/rough_conductor_material.h"
#include "modeler/diffuse_box.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(4);
const BoxFilter box;

std::shared_ptr<const Texture> grey(Real value) { return std::make_shared<ConstantTexture>(Color::Constant(value)); }

std::shared_ptr<const Material> diffuse(Real reflectance) {
    return std::make_shared<DiffuseMaterial>(Color::Constant(reflectance));
}

SceneObject lamp(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV, Real radiance) {
    return {.shape = std::make_shared<Rectangle>(corner, edgeU, edgeV), .emission = grey(radiance)};
}

// Splats go to pixels far away, whoever's turn it is: their order is that of the paths.
TEST(Threads, DoNotChangeABit) {
    const Scene scene(peersBox(24, 24));
    const TentFilter tent;
    PathTracer path(scene, sampler, tent, {});
    LightTracer light(scene, sampler, tent, {});
    BidirectionalPathTracer both(scene, sampler, tent, {});
    for (Integrator* const one : std::initializer_list<Integrator*>{&path, &light, &both}) {
        const Rendering alone = render(*one, {.passes = 3});
        const Rendering shared = render(*one, {.passes = 3, .threads = 2});
        for (int p = 0; p < 24 * 24; ++p) {
            const Pixel pixel = {p % 24, p / 24};
            EXPECT_TRUE((alone.film.value(pixel) == shared.film.value(pixel)).all());
        }
        EXPECT_EQ(alone.counts.rays, shared.counts.rays);
    }
}

// Without glass, mirrors, lens and textures nothing of them is asked for; and paths ask as often as they have vertices.
TEST(Parsimony, WhatASceneDoesNotNeedIsNotAsked) {
    const Scene scene(DiffuseBox().scene(16, 16));
    const PathLimits limits = {.maxLength = 3, .rouletteStart = 9};
    const auto countsOf = [](auto integrator) { return render(integrator, {.passes = 4}).counts; };
    const RayCounts chance = countsOf(PathTracer(scene, sampler, box, {limits, Direct::ByChance}));
    const RayCounts direct = countsOf(PathTracer(scene, sampler, box, {limits, Direct::DirectLight}));
    const RayCounts light = countsOf(LightTracer(scene, sampler, box, limits));
    const RayCounts both = countsOf(BidirectionalPathTracer(scene, sampler, box, limits));
    for (const RayCounts& one : {chance, direct, light, both}) {
        EXPECT_EQ(one.crossings, 0);
        EXPECT_EQ(one.transmittances, 0);
        EXPECT_EQ(one.distanceSamples, 0);
        EXPECT_EQ(one.lensSamples, 0);
        EXPECT_EQ(one.textureLookups, 0);
    }
    constexpr std::int64_t paths = 16 * 16 * 4;
    EXPECT_EQ(chance.shadowRays, 0) << "who waits for chance asks for nothing";
    EXPECT_LE(chance.rays, 3 * paths);
    EXPECT_LE(direct.shadowRays, 2 * paths) << "the last vertex would make the path too long";
    EXPECT_LE(light.rays, 3 * paths) << "one ray from the eye, two segments of a path from the light";
    EXPECT_LE(light.shadowRays, 2 * paths);
    // (1, 2), (1, 3), (2, 1), (3, 1), (2, 2) of at most three segments.
    EXPECT_LE(both.shadowRays, 5 * paths);
    EXPECT_LE(both.rays, 5 * paths);
}

// A path of one segment only sees lights, and no walk sets out from them.
TEST(Parsimony, ShortestPathsWalkNowhere) {
    const Scene scene(DiffuseBox().scene(16, 16));
    const PathLimits limits = {.maxLength = 1, .rouletteStart = 0};
    LightTracer light(scene, sampler, box, limits);
    BidirectionalPathTracer both(scene, sampler, box, limits);
    for (Integrator* const one : std::initializer_list<Integrator*>{&light, &both}) {
        const RayCounts counts = render(*one, {.passes = 1}).counts;
        EXPECT_EQ(counts.rays, 256);
        EXPECT_EQ(counts.shadowRays, 0);
    }
}

std::vector<std::shared_ptr<const Light>> threeLights() {
    return {std::make_shared<PointLight>(Vec3(0, 0, 1), Color(1, 2, 0)),
            std::make_shared<ConeLight>(Vec3(0, 0, 1), Vec3::UnitX(), 0.3, Color::Constant(5)),
            std::make_shared<PointLight>(Vec3(0, 3, 1), Color::Zero())};
}

TEST(LightChoice, IsByPower) {
    const auto lights = threeLights();
    const LightChoice choice(lights);
    const Real point = 8 * pi;
    const Real cone = 2 * pi * (1 - std::cos(0.3)) * 5;
    EXPECT_NEAR(choice.probability(*lights[0]), point / (point + cone), 1e-14);
    EXPECT_NEAR(choice.probability(*lights[1]), cone / (point + cone), 1e-14);
    EXPECT_EQ(choice.probability(*lights[2]), 0);
    constexpr int n = 100'000;
    int points = 0;
    for (int i = 0; i < n; ++i) {
        const auto one = choice.choose((i + 0.5) / n);
        ASSERT_TRUE(one);
        EXPECT_EQ(one->probability, choice.probability(*one->light));
        points += one->light == lights[0].get() ? 1 : 0;
    }
    EXPECT_NEAR(Real(points) / n, point / (point + cone), 2.0 / n);
    EXPECT_EQ(choice.choose(std::nextafter(1.0, 0.0))->light, lights[1].get()) << "never the one that is dark";
    EXPECT_FALSE(LightChoice({}).choose(0.5));
    EXPECT_FALSE(LightChoice({lights[2]}).choose(0.5));
    EXPECT_TRUE(choice.infinite().empty());
}

// All walks together carry all light: the mean throughput at the start is the sum of the lights' powers.
TEST(LightStart, CarriesThePowerOfAllLights) {
    SceneDescription description;
    description.objects = {lamp({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, 3),
                           {.shape = std::make_shared<Sphere>(Vec3(5, 0, 0), 0.5), .emission = grey(1)}};
    description.lights = {std::make_shared<PointLight>(Vec3(0, 0, 1), Color(1, 2, 0)),
                          std::make_shared<ConeLight>(Vec3(0, 0, 1), Vec3::UnitX(), 0.3, Color::Constant(5)),
                          std::make_shared<ConstantEnvironment>(Color::Constant(0.01))};
    const Scene scene(description);
    const LightChoice lights(scene.lights());
    Color power = Color::Zero();
    for (const auto& light : scene.lights()) power += light->power();
    Color sum = Color::Zero();
    Color squares = Color::Zero();
    constexpr int n = 50'000;
    for (int i = 0; i < n; ++i) {
        const auto start = startAtLight(scene, lights, sampler.start(1, {0, 0}, i));
        ASSERT_TRUE(start);
        sum += start->beta;
        squares += start->beta.square();
    }
    const Color mean = sum / n;
    const Color error = ((squares / n - mean.square()) / n).max(0).sqrt();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], power[c], 5 * error[c] + 1e-9 * power[c]);
}

// What the strategies contribute is what the path brings, and what Li brings is the same without a film.
TEST(Bidirectional, IsTheSumOfItsStrategies) {
    const Scene scene(peersBox(16, 16));
    const BidirectionalPathTracer tracer(scene, sampler, box, {});
    RayCounts counts;
    for (int p = 0; p < 256; ++p) {
        const PathId path = {{p % 16, p / 16}, 7};
        std::vector<Splat> splats;
        const Color value = tracer.tracePath(path, splats, counts);
        Color sum = Color::Zero();
        std::size_t splatted = 0;
        for (const StrategyContribution& one : tracer.contributions(path, counts)) {
            EXPECT_GE(one.weight, 0);
            EXPECT_LE(one.weight, 1);
            EXPECT_LE(one.s + one.t - 1, 10);
            EXPECT_GE(one.t, 1);
            EXPECT_FALSE(one.t == 1 && one.s < 2) << "lights that are seen directly come by (0, 2)";
            if (one.t > 1) sum += one.weight * one.value;
            if (one.t == 1) {
                ASSERT_LT(splatted, splats.size());
                EXPECT_TRUE((splats[splatted].value == one.weight * one.value).all());
                EXPECT_EQ(splats[splatted++].film, one.film);
            }
        }
        EXPECT_EQ(splatted, splats.size());
        EXPECT_TRUE((sum == value).all());
    }
}

TEST(Bidirectional, LiNeedsNoFilm) {
    SceneDescription furnace;
    furnace.objects = {{.shape = std::make_shared<Sphere>(Vec3::Zero(), 1.0), .material = diffuse(1)}};
    furnace.lights = {std::make_shared<ConstantEnvironment>(Color::Constant(2))};
    const Scene scene(furnace);
    const BidirectionalPathTracer tracer(scene, sampler, box, {});
    RayCounts counts;
    Real sum = 0;
    Real squares = 0;
    constexpr int n = 100'000;
    for (int i = 0; i < n; ++i) {
        const Real one = tracer.Li({Vec3(0.3, 0.4, 5), -Vec3::UnitZ()}, {}, sampler.start(0, {0, 0}, i), counts).x();
        sum += one;
        squares += one * one;
    }
    const Real mean = sum / n;
    EXPECT_NEAR(mean, 2, 5 * std::sqrt((squares / n - mean * mean) / n));
    EXPECT_EQ(counts.lensSamples, 0);
}

// The variance of a pixel's paths.
Real varianceOf(const Scene& scene, Direct direct) {
    const PathTracer tracer(scene, sampler, box, {{.maxLength = 2, .rouletteStart = 0}, direct});
    RayCounts counts;
    std::vector<Splat> splats;
    Real sum = 0;
    Real squares = 0;
    constexpr int n = 100'000;
    for (int i = 0; i < n; ++i) {
        const Real one = tracer.tracePath({{0, 0}, i}, splats, counts).x();
        sum += one;
        squares += one * one;
    }
    return squares / n - sum * sum / n / n;
}

// A floor from matt to nearly a mirror, under lamps from tiny to large, one or many: chance is good for sharp lobes and
// large lamps, asking for the others. Both together are never much worse than the better one of them.
TEST(Mis, IsNeverMuchWorseThanItsBetterPart) {
    Real worst = 0;
    Real greatestGain = 1;
    for (const int lamps : {1, 9, 36}) {
        for (const Real side : {0.02, 0.1, 0.3}) {
            for (const Real exponent : {0.0, 10.0, 100.0, 1000.0, 20000.0}) {
                SceneDescription description;
                const auto glossy = std::make_shared<PhongMaterial>(grey(0.2), Color::Constant(0.6), exponent);
                description.objects = {
                    {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = glossy}};
                const int perAxis = static_cast<int>(std::lround(std::sqrt(lamps)));
                for (int k = 0; k < lamps; ++k) {
                    const Vec3 corner(0.4 * (k % perAxis - (perAxis - 1) / 2.0) - side / 2, 1,
                                      0.4 * (k / perAxis - (perAxis - 1) / 2.0) - side / 2);
                    description.objects.push_back(lamp(corner, {side, 0, 0}, {0, 0, side}, 1 + k % 4));
                }
                description.camera =
                    std::make_shared<PinholeCamera>(Vec3(-0.8, 0.8, 0.1), Vec3(0, 0, 0), Vec3::UnitY(), 0.05, 1, 1);
                const Scene scene(description);
                const Real chance = varianceOf(scene, Direct::ByChance);
                const Real asked = varianceOf(scene, Direct::DirectLight);
                const Real both = varianceOf(scene, Direct::Mis);
                const Real ratio = both / std::min(chance, asked);
                worst = std::max(worst, ratio);
                greatestGain = std::max(greatestGain, std::max(chance, asked) / both);
            }
        }
    }
    EXPECT_LE(worst, 1.1);
    EXPECT_GE(greatestGain, 100) << "than the worse one";
}

}  // namespace
}  // namespace caustic
