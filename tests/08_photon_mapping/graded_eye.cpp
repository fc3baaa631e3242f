#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "integrator/photon_mapper.h"
#include "light/cone_light.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "support/coloured_fog.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(7);
const BoxFilter filter;
const Color rho(0.6, 0.3, 0.45);
const Color intensity(4, 0.7, 2);

SceneObject object(std::shared_ptr<const Shape> shape, std::shared_ptr<const Material> material) {
    return {std::move(shape), std::move(material), {}, nullptr};
}

SceneDescription describe(std::vector<SceneObject> objects, const std::shared_ptr<Light>& light) {
    return {std::move(objects), {light}, Color::Zero(), nullptr};
}

// The mean of what comes along a ray.
Color seen(const Scene& scene, const PhotonMapperSettings& settings, const Ray& ray, int paths) {
    const PhotonMapper mapper(scene, sampler, filter, settings, 1);
    RayCounts counts;
    Color sum = Color::Zero();
    for (int i = 0; i < paths; ++i)
        sum += mapper.Li(ray, scene.mediaAt(ray.origin), sampler.start(0, {0, 0}, i), counts);
    return sum / paths;
}

void expectSeen(const Color& found, const Color& expected, Real share, const std::string& question) {
    EXPECT_LE((found / expected - 1).abs().maxCoeff(), share)
        << question << "\nfound " << found.transpose() << ", expected " << expected.transpose();
}

constexpr MapUse uses[] = {MapUse::Everything, MapUse::Indirect, MapUse::Gather};

// A floor under a point lamp: ρ/π I cos θ/d², from samples or from photons, and once.
TEST(Eye, SeesDirectLightOnce) {
    const Vec3 lamp(3, 2, -1);
    const Scene scene(
        describe({object(std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), std::make_shared<DiffuseMaterial>(rho))},
                 std::make_shared<ConeLight>(lamp, Vec3(-0.2, -2, 0), 0.5, intensity)));
    const Vec3 target(2.9, 0, -1);
    const Color expected = rho / pi * intensity * 2 / std::pow((lamp - target).norm(), 3);
    const Ray ray{Vec3(4, 1, 0), (target - Vec3(4, 1, 0)).normalized()};
    for (const MapUse use : uses) {
        PhotonMapperSettings settings = {.photons = 60'000, .use = use, .density = {.nearest = 2000, .radius = 0.2}};
        const Color found = seen(scene, settings, ray, 20);
        expectSeen(found, expected, use == MapUse::Everything ? 0.12 : 1e-9,
                   "Is the light that comes straight from the lamp there, and there once?");
    }
    const PhotonMapperSettings single = {
        .photons = 1, .use = MapUse::Everything, .density = {.nearest = {}, .radius = 3}};
    EXPECT_GT(seen(scene, single, ray, 1).minCoeff(), 0) << "Is a map of one photon empty?";
}

// A cone of light is thrown onto the floor by a mirror: direct light finds nothing. The same lamp behind the mirror
// would bring I cos θ/d².
TEST(Eye, SeesCausticsOnce) {
    const Vec3 lamp(0.2, 1.2, 0.1);
    const Vec3 image(-2.2, 1.2, 0.1);
    const Vec3 target(0.9, 0, -0.2);
    const Scene scene(describe(
        {object(std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), std::make_shared<DiffuseMaterial>(rho)),
         object(std::make_shared<Rectangle>(Vec3(-1, 0.1, -3), Vec3(0, 0, 6), Vec3(0, 4, 0)),
                std::make_shared<MirrorMaterial>(Color(0.9, 0.5, 0.7)))},
        std::make_shared<ConeLight>(lamp, Vec3(-2 - target.x(), target.y(), target.z()) - lamp, 0.1, intensity)));
    const Color expected =
        rho / pi * Color(0.9, 0.5, 0.7) * intensity * image.y() / std::pow((image - target).norm(), 3);
    for (const MapUse use : uses) {
        PhotonMapperSettings settings = {.photons = 40'000, .use = use};
        settings.density = {.nearest = 900, .radius = 0.2};
        settings.caustics = settings.density;
        const Color found = seen(scene, settings, {Vec3(2, 1, 0), (target - Vec3(2, 1, 0)).normalized()}, 20);
        expectSeen(found, expected, 0.2, "Is the light that a mirror brings there, and there once?");
    }
    const PhotonMapperSettings single = {
        .photons = 1, .use = MapUse::Indirect, .caustics = {.nearest = {}, .radius = 3}};
    EXPECT_GT(seen(scene, single, {Vec3(2, 1, 0), (target - Vec3(2, 1, 0)).normalized()}, 1).minCoeff(), 0)
        << "Is a map of one photon empty?";
}

// A closed room, its walls all alike and lit from its middle: in the mean they get E = Φ/(A (1 − ρ)). Far from edges
// the indirect part is about the mean: ρ E. What is seen is ρ/π of direct and indirect light together.
TEST(Eye, SeesIndirectLightOnce) {
    const Scene scene(describe(
        {object(std::make_shared<Box>(Vec3(9, -1, -1), Vec3(11, 1, 1)), std::make_shared<DiffuseMaterial>(rho))},
        std::make_shared<PointLight>(Vec3(10, 0, 0), intensity)));
    const Color direct = rho / pi * intensity;
    Color found[2];
    for (int i = 0; i < 2; ++i) {
        PhotonMapperSettings settings = {.photons = 60'000, .use = uses[i + 1]};
        settings.density = {.nearest = 1500, .radius = 0.3};
        settings.gatherRays = 64;
        found[i] = seen(scene, settings, {Vec3(10, 0.3, 0.2), -Vec3::UnitY()}, 60);
        const Color mean = rho * rho / (1 - rho) * 4 * pi * intensity / 24 / pi;
        EXPECT_GT(((found[i] - direct) / mean).minCoeff(), 0.7) << "Is light that walls send to each other missing?";
        EXPECT_LT(((found[i] - direct) / mean).maxCoeff(), 1.4) << "Does any light count twice?";
    }
    expectSeen(found[1], found[0], 0.1, "Do both uses of photons show the same?");
}

// A lamp that shines away from all there is leaves no photon anywhere.
TEST(Eye, AsksNothingOfAnEmptyMap) {
    const Scene scene(
        describe({object(std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), std::make_shared<DiffuseMaterial>(rho))},
                 std::make_shared<ConeLight>(Vec3(3, 2, -1), Vec3(0.2, 2, 0), 0.5, intensity)));
    for (const MapUse use : uses) {
        const PhotonMapper mapper(scene, sampler, filter, {.photons = 1000, .use = use}, 1);
        RayCounts counts;
        const Color found = mapper.Li({Vec3(4, 1, 0), -Vec3::UnitY()}, {}, sampler.start(0, {0, 0}, 0), counts);
        EXPECT_TRUE((found == 0).all()) << "What light is there? found " << found.transpose();
        EXPECT_EQ(counts.rays, 1) << "Who sends rays to gather from a map that holds nothing?";
    }
}

// At a point where a medium scatters no photons lie; what it gets straight from the lamp is seen all the same. Those on
// the floor below are a surface's.
TEST(Eye, SeesDirectLightInAMedium) {
    SceneObject fog = object(std::make_shared<Box>(Vec3(-1, -1, -1), Vec3(1, 1, 1)), nullptr);
    fog.interior = Interior{1, std::make_shared<test::ColouredFog>(Color::Zero(), Color::Constant(0.02)), 0};
    const Scene scene(describe({fog,
                                object(std::make_shared<Box>(Vec3(-9, -9, -9), Vec3(9, 9, 9)),
                                       std::make_shared<DiffuseMaterial>(Color::Zero())),
                                object(std::make_shared<Rectangle>(Vec3(-3, -1.1, -3), Vec3(0, 0, 6), Vec3(6, 0, 0)),
                                       std::make_shared<DiffuseMaterial>(Color::Constant(0.9)))},
                               std::make_shared<PointLight>(Vec3(0, 3, 0), intensity)));
    for (const MapUse use : {MapUse::Indirect, MapUse::Gather}) {
        const Color found = seen(scene, {.photons = 2000, .use = use}, {Vec3(-5, 0, 0), Vec3::UnitX()}, 20'000);
        // Single scattering: σ_s p I ∫ T/d² along the way, almost nothing of it lost.
        Color expected = Color::Zero();
        for (int i = 0; i < 1000; ++i) {
            const Real x = (i + 0.5) / 500 - 1;
            const Real squared = x * x + 9;
            const Real way = 1 + x + std::sqrt(squared) / 3;
            expected += 0.02 / (4 * pi) * intensity * std::exp(-0.02 * way) / squared / 500;
        }
        expectSeen(found, expected, 0.25, "Is direct light, and nothing else, sampled where a medium scatters, too?");
    }
}

}  // namespace
}  // namespace caustic
