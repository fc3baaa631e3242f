#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "camera/tent_filter.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/conductor_material.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/refraction_material.h"
#include "material/rough_conductor_material.h"
#include "material/rough_dielectric_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/in_cube.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

const IndependentSampler sampler(9);
const TentFilter tent;
const BoxFilter box;
constexpr PathLimits limits = {.maxLength = 9, .rouletteStart = 2};

std::shared_ptr<const Texture> grey(Real value) { return std::make_shared<ConstantTexture>(Color::Constant(value)); }

std::shared_ptr<const Material> diffuse(Real reflectance) {
    return std::make_shared<DiffuseMaterial>(Color::Constant(reflectance));
}

// Every method once.
void forEachMethod(const Scene& scene, const PixelFilter& filter,
                   const std::function<void(const std::string& name, Integrator&)>& use) {
    const auto with = [&use](const std::string& name, auto integrator) { use(name, integrator); };
    with("path tracing by chance", PathTracer(scene, sampler, filter, {limits, Direct::ByChance}));
    with("path tracing, direct light", PathTracer(scene, sampler, filter, {limits, Direct::DirectLight}));
    with("path tracing, both", PathTracer(scene, sampler, filter, {limits, Direct::Mis}));
    with("light tracing", LightTracer(scene, sampler, filter, limits));
    with("bidirectional", BidirectionalPathTracer(scene, sampler, filter, limits));
}

// No sample of any method may be infinite or not a number, or negative.
void expectNumbers(SceneDescription description, const std::string& what, int samples) {
    const Scene scene(std::move(description));
    forEachMethod(scene, tent, [&](const std::string& name, Integrator& integrator) {
        const Rendering rendering = render(integrator, {.passes = samples});
        EXPECT_EQ(rendering.film.badSamples(), 0) << what << ", " << name;
        const Camera& camera = scene.camera();
        Real least = 0;
        for (int y = 0; y < camera.height(); ++y) {
            for (int x = 0; x < camera.width(); ++x) least = std::min(least, rendering.film.value({x, y}).minCoeff());
        }
        EXPECT_EQ(least, 0) << what << ", " << name;
    });
}

std::shared_ptr<const Material> anyMaterial(Random& random) {
    const Real rough = random.below(3) == 0 ? 0 : random.uniform();
    switch (random.below(9)) {
        case 0:
            return diffuse(random.below(2) == 0 ? 1 : 0);
        case 1:
            return std::make_shared<MirrorMaterial>(Color(1, 0.5, 0));
        case 2:
            return std::make_shared<RefractionMaterial>(Color::Constant(0.1), Color::Constant(0.9));
        case 3:
            return std::make_shared<PhongMaterial>(grey(0.5), Color::Constant(0.5), random.uniform(0, 500));
        case 4:
            return std::make_shared<DielectricMaterial>();
        case 5:
            return std::make_shared<RoughDielectricMaterial>(rough, random.uniform());
        case 6:
            return std::make_shared<RoughConductorMaterial>(Metal::gold(), rough, random.uniform());
        case 7:
            return std::make_shared<ConductorMaterial>(Metal::copper());
        default:
            return diffuse(0.7);
    }
}

// Balls of every material that overlap, touch and contain each other, the camera and the lights.
TEST(Numbers, RandomScenes) {
    for (std::uint64_t i = 0; i < 40; ++i) {
        Random random(2, {i});
        SceneDescription description;
        for (int k = 0; k < 6; ++k) {
            SceneObject ball;
            ball.shape = std::make_shared<Sphere>(test::inCube(random), random.uniform(0.1, 0.8));
            ball.material = anyMaterial(random);
            if (random.below(2) == 0)
                ball.interior = Interior{random.below(4) == 0 ? 1 : random.uniform(0.5, 2.5),
                                         std::make_shared<AbsorbingMedium>(Color(random.uniform(0, 9), 0, 1)),
                                         static_cast<int>(random.below(3))};
            if (random.below(3) == 0) ball.emission = grey(3);
            description.objects.push_back(ball);
        }
        description.objects.push_back(
            {.shape = std::make_shared<Plane>(Vec3(0, -1, 0), Vec3::UnitY()), .material = anyMaterial(random)});
        description.lights = {
            std::make_shared<PointLight>(test::inCube(random), Color::Ones()),
            std::make_shared<ConeLight>(test::inCube(random), test::inCube(random), 0.6, Color::Ones())};
        if (random.below(2) == 0) description.lights.push_back(std::make_shared<ConstantEnvironment>(Color(0.5, 1, 2)));
        description.camera = std::make_shared<PinholeCamera>(2 * test::inCube(random), test::inCube(random),
                                                             Vec3(0.1, 1, 0.2), 0.9, 12, 12);
        expectNumbers(description, "scene " + std::to_string(i), 16);
    }
}

// A room with one thing in its middle, a lamp that touches the ceiling, and corners everywhere.
SceneDescription roomWith(const SceneObject& thing) {
    SceneDescription room;
    const auto wall = [&](const Vec3& corner, const Vec3& u, const Vec3& v) {
        room.objects.push_back({.shape = std::make_shared<Rectangle>(corner, u, v), .material = diffuse(1)});
    };
    wall({-1, -1, -1}, {0, 0, 2}, {2, 0, 0});
    wall({-1, 1, -1}, {2, 0, 0}, {0, 0, 2});
    wall({-1, -1, -1}, {0, 2, 0}, {0, 0, 2});
    wall({1, -1, -1}, {0, 0, 2}, {0, 2, 0});
    wall({-1, -1, -1}, {2, 0, 0}, {0, 2, 0});
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-0.3, 1, -0.3), Vec3(0.6, 0, 0), Vec3(0, 0, 0.6));
    lamp.emission = grey(5);
    room.objects.push_back(lamp);
    room.objects.push_back(thing);
    room.camera = std::make_shared<PinholeCamera>(Vec3(0, 0, 2.5), Vec3(0, 0, 0), Vec3::UnitY(), 0.9, 16, 16);
    return room;
}

SceneObject ball(const std::shared_ptr<const Material>& material, Real ior = 0) {
    SceneObject one = {.shape = std::make_shared<Sphere>(Vec3(0, -0.5, 0), 0.5), .material = material};
    if (ior > 0) one.interior = Interior{ior, nullptr, 0};
    return one;
}

TEST(Numbers, MaterialsAtTheirLimits) {
    const auto glass = std::make_shared<DielectricMaterial>();
    expectNumbers(roomWith(ball(diffuse(0))), "albedo 0", 16);
    expectNumbers(roomWith(ball(diffuse(1))), "albedo 1, a ball that touches the floor", 16);
    expectNumbers(roomWith(ball(glass, 1)), "index 1", 16);
    expectNumbers(roomWith(ball(glass, 1 + 1e-12)), "index nearly 1", 16);
    expectNumbers(roomWith(ball(glass, 0.5)), "critical angle from outside", 16);
    expectNumbers(roomWith(ball(glass, 1e6)), "index of a million", 16);
    for (const Real roughness : {0.0, 1e-6, 1e-3, 1.0}) {
        const std::string name = "roughness " + std::to_string(roughness);
        expectNumbers(roomWith(ball(std::make_shared<RoughDielectricMaterial>(roughness, roughness), 1.5)), name, 16);
        expectNumbers(roomWith(ball(std::make_shared<RoughConductorMaterial>(Metal::silver(), roughness, 1))), name,
                      16);
    }
    const auto sharp = std::make_shared<PhongMaterial>(grey(0), Color::Ones(), 1e6);
    expectNumbers(roomWith(ball(sharp)), "a very sharp highlight", 16);
}

TEST(Numbers, LightsAndCamerasInOddPlaces) {
    const auto glass = std::make_shared<DielectricMaterial>();
    SceneDescription room = roomWith(ball(glass, 1.5));
    const auto withLight = [&](const std::shared_ptr<Light>& light, const std::string& what) {
        SceneDescription one = room;
        one.lights = {light};
        expectNumbers(one, what, 16);
    };
    withLight(std::make_shared<PointLight>(Vec3(0, -0.5, 0), Color::Ones()), "a light inside glass");
    withLight(std::make_shared<PointLight>(Vec3(0, 0, 0), Color::Ones()), "a light on the boundary of glass");
    withLight(std::make_shared<PointLight>(Vec3(0.2, -1, 0.3), Color::Ones()), "a light on the floor");
    withLight(std::make_shared<PointLight>(Vec3(-1, -1, -1), Color::Ones()), "a light in the corner");
    withLight(std::make_shared<PointLight>(Vec3(0, 0, 2.5), Color::Ones()), "a light at the pinhole");
    withLight(std::make_shared<ConeLight>(Vec3(0, 0.5, 0), -Vec3::UnitY(), 1e-9, Color::Ones()), "a very narrow cone");

    SceneDescription inside = room;
    inside.camera = std::make_shared<PinholeCamera>(Vec3(0, -0.5, 0.1), Vec3(0, -0.4, -1), Vec3::UnitY(), 1.5, 16, 16);
    expectNumbers(inside, "the camera inside glass", 16);
    inside.camera = std::make_shared<PinholeCamera>(Vec3(0, -1, 0.9), Vec3(0, -1, -1), Vec3::UnitY(), 1.5, 16, 16);
    expectNumbers(inside, "the camera within the floor's plane: grazing", 16);

    SceneObject glowing = ball(glass, 1.5);
    glowing.emission = grey(2);
    expectNumbers(roomWith(glowing), "glass that glows", 16);
    SceneObject touching;
    touching.shape = std::make_shared<Rectangle>(Vec3(0.2, -1, -0.5), Vec3(0, 0, 1), Vec3(0, 1, 0));
    touching.emission = grey(5);
    expectNumbers(roomWith(touching), "a lamp that stands on the floor", 16);
}

TEST(Numbers, SurfacesInContact) {
    SceneDescription room = roomWith(ball(std::make_shared<DielectricMaterial>(), 1.5));
    // Twice the same floor, a box on it, glass beside it with a common face.
    room.objects.push_back(room.objects[0]);
    room.objects.push_back(
        {.shape = std::make_shared<Box>(Vec3(-0.9, -1, -0.9), Vec3(-0.5, 0, -0.5)), .material = diffuse(0.5)});
    room.objects.push_back({.shape = std::make_shared<Box>(Vec3(-0.5, -1, -0.9), Vec3(-0.2, 0, -0.5)),
                            .material = std::make_shared<RoughDielectricMaterial>(0.3, 0.3),
                            .interior = Interior{1.5, nullptr, 0}});
    expectNumbers(room, "contact", 64);
}

// A scene in which nothing shines, and one without anything.
TEST(Numbers, Darkness) {
    SceneDescription dark = roomWith(ball(diffuse(0.5)));
    dark.objects[5].emission = grey(0);
    expectNumbers(dark, "a lamp of no power", 4);
    SceneDescription empty;
    empty.camera = dark.camera;
    expectNumbers(empty, "nothing", 4);
    empty.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
    expectNumbers(empty, "nothing but the sky", 4);
}

// What a corner does to the geometry term: the strategy by itself has no bound, its weight times it has one. 1/d² goes
// with a walk that would find the near point by chance.
TEST(Corners, AConnectionHasNoBoundItsWeightHas) {
    const Scene scene(roomWith(ball(diffuse(0.5))));
    const BidirectionalPathTracer tracer(scene, sampler, box, limits);
    RayCounts counts;
    Real largest = 0;
    Real largestWeighted = 0;
    for (std::int64_t i = 0; i < 400; ++i) {
        for (int pixel = 0; pixel < 256; ++pixel) {
            for (const StrategyContribution& one : tracer.contributions({{pixel % 16, pixel / 16}, i}, counts)) {
                if (one.s < 2 || one.t < 2) continue;
                largest = std::max(largest, one.value.maxCoeff());
                largestWeighted = std::max(largestWeighted, one.weight * one.value.maxCoeff());
            }
        }
    }
    EXPECT_LE(largestWeighted, 30) << "the lamp's radiance is 5";
    EXPECT_GE(largest, 20 * largestWeighted) << "and by itself: " << largest << " " << largestWeighted;
}

// Where each method must fail: a light at a point, seen over a mirror or through glass, is not to be hit; a mirror
// never shows anything to the lights.
TEST(Failures, WhatAMethodCannotMakeIsDark) {
    // A mirror above the floor sends the light of a point down.
    SceneDescription description;
    description.objects = {{.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = diffuse(0.6)},
                           {.shape = std::make_shared<Plane>(Vec3(0, 3, 0), -Vec3::UnitY()),
                            .material = std::make_shared<MirrorMaterial>(Color::Constant(0.7))},
                           {.shape = std::make_shared<Sphere>(Vec3(0, 1, 0), 0.1), .material = diffuse(0)}};
    description.lights = {std::make_shared<ConeLight>(Vec3(0, 2, 0), Vec3::UnitY(), 0.5, Color::Constant(5))};
    description.camera = std::make_shared<PinholeCamera>(Vec3(0.5, 1, 0.5), Vec3(0.3, 0, 0.3), Vec3::UnitY(), 1, 8, 8);
    const auto mean = [](auto integrator) {
        const Rendering rendering = render(integrator, {.passes = 64});
        Real sum = 0;
        for (int p = 0; p < 64; ++p) sum += rendering.film.value({p % 8, p / 8}).mean();
        return sum / 64;
    };
    const Scene caustic(description);
    EXPECT_EQ(mean(PathTracer(caustic, sampler, box, {limits, Direct::Mis})), 0) << "a caustic of a point";
    EXPECT_GE(mean(LightTracer(caustic, sampler, box, limits)), 0.01);
    EXPECT_GE(mean(BidirectionalPathTracer(caustic, sampler, box, limits)), 0.01);

    // The floor seen over the mirror.
    description.camera = std::make_shared<PinholeCamera>(Vec3(0.5, 1, 0.5), Vec3(0.6, 3, 0.5), Vec3::UnitX(), 1, 8, 8);
    description.lights = {std::make_shared<PointLight>(Vec3(0, 2, 0), Color::Constant(5))};
    const Scene mirrored(description);
    EXPECT_EQ(mean(LightTracer(mirrored, sampler, box, limits)), 0) << "a mirror";
    EXPECT_GE(mean(PathTracer(mirrored, sampler, box, {limits, Direct::Mis})), 0.01);

    // And both at once: the caustic, seen over the mirror. Nothing makes specular, diffuse, specular of a point.
    description.lights = {std::make_shared<ConeLight>(Vec3(0, 2, 0), Vec3::UnitY(), 0.5, Color::Constant(5))};
    description.objects[0].material = diffuse(0.6);
    const Scene between(description);
    const PathLimits once = {.maxLength = 4, .rouletteStart = 9};
    EXPECT_EQ(mean(LightTracer(between, sampler, box, once)), 0);
    EXPECT_EQ(mean(PathTracer(between, sampler, box, {once, Direct::Mis})), 0);
    EXPECT_EQ(mean(BidirectionalPathTracer(between, sampler, box, once)), 0);
}

TEST(BadInput, Limits) {
    const Scene scene(roomWith(ball(diffuse(0.5))));
    for (const PathLimits& bad : {PathLimits{0, 3}, PathLimits{-1, 3}, PathLimits{5, -1}}) {
        EXPECT_THROW(PathTracer(scene, sampler, box, {bad, Direct::Mis}), InputError);
        EXPECT_THROW(LightTracer(scene, sampler, box, bad), InputError);
        EXPECT_THROW(BidirectionalPathTracer(scene, sampler, box, bad), InputError);
    }
}

}  // namespace
}  // namespace caustic
