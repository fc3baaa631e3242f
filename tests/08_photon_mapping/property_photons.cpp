#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "integrator/path_tracer.h"
#include "integrator/photon_mapper.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "medium/absorbing_medium.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/sphere.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(3);
const BoxFilter filter;
const Color rho(0.6, 0.3, 0.45);
const Color intensity(4, 0.7, 2);

// A closed lopsided room far from the origin.
SceneDescription room(std::vector<std::shared_ptr<Light>> lights, std::vector<SceneObject> more = {}) {
    more.push_back({std::make_shared<Box>(Vec3(5, -3, 2), Vec3(7.3, -2, 3.4)),
                    std::make_shared<DiffuseMaterial>(rho),
                    {},
                    nullptr});
    return {std::move(more), std::move(lights), Color::Zero(), nullptr};
}

const Vec3 somewhere(5.6, -2.4, 2.9);

std::shared_ptr<Light> pointLight() { return std::make_shared<PointLight>(somewhere, intensity); }
std::shared_ptr<Light> coneLight() {
    return std::make_shared<ConeLight>(somewhere, Vec3(1, 0.2, -0.4), 0.5, intensity);
}

std::vector<Photon> traced(const SceneDescription& description, const PhotonSettings& settings, std::int64_t count) {
    const Scene scene(description);
    RayCounts counts;
    return tracePhotons(scene, LightChoice(scene.lights()), sampler, settings, 0, count, 2, counts);
}

Color total(const std::vector<Photon>& photons) {
    Color sum = Color::Zero();
    for (const Photon& photon : photons) sum += photon.power;
    return sum;
}

void expectWithin(const Color& found, const Color& expected, Real share) {
    EXPECT_LE((found / expected - 1).abs().maxCoeff(), share)
        << "found " << found.transpose() << ", expected " << expected.transpose();
}

// All bounces in a closed room bring Φ/(1 − ρ). Without roulette every photon of a lamp brings that by itself.
TEST(PhotonPower, IsThatOfAllLampsInAClosedRoom) {
    const PathLimits toTheEnd = {80, 500};
    for (const auto& light : {pointLight(), coneLight()})
        expectWithin(total(traced(room({light}), {toTheEnd}, 1000)), light->power() / (1 - rho), 1e-3);
    // The choice among lamps of different colours has noise, and so has roulette: 100,000 photons, standard errors of
    // 0.3 % at most.
    const Color power = pointLight()->power() + coneLight()->power();
    expectWithin(total(traced(room({pointLight(), coneLight()}), {{200, 0}}, 100'000)), power / (1 - rho), 0.02);
}

// A lamp with an extent: what comes straight from it is all of its light, π L A.
TEST(PhotonPower, IsThatOfARectangle) {
    const SceneObject lamp = rectangleLamp({5.5, -2.001, 2.5}, {0.7, 0, 0}, {0, 0, 0.4}, Color(7, 3, 1));
    expectWithin(total(traced(room({}, {lamp}), {{1, 1}}, 1000)), pi * 0.28 * Color(7, 3, 1), 1e-9);
}

// Glass takes nothing: from a lamp inside of it all light gets to the walls, split or not.
TEST(PhotonPower, LeavesGlass) {
    for (const int splits : {0, 3}) {
        const auto photons =
            traced(room({pointLight()}, {glassBall(somewhere + Vec3(0.1, 0, 0), 0.3, 1.7)}), {{14, 14}, splits}, 4'000);
        Color first = Color::Zero();
        for (const Photon& photon : photons) {
            EXPECT_NE(photon.way, PhotonWay::Direct);
            if (photon.way == PhotonWay::Caustic) first += photon.power;
        }
        expectWithin(first, pointLight()->power(), splits == 0 ? 1e-3 : 0.02);
    }
}

// A black ball under a sky of one radiance gets E = π L everywhere.
TEST(PhotonPower, ComesFromTheSky) {
    const Color sky(3, 1, 0.4);
    const SceneObject ball = {
        std::make_shared<Sphere>(Vec3(3, 1, -2), 0.7), std::make_shared<DiffuseMaterial>(Color::Zero()), {}, nullptr};
    const SceneObject other = {
        std::make_shared<Sphere>(Vec3(5, 1, -2), 0.2), std::make_shared<DiffuseMaterial>(Color::Zero()), {}, nullptr};
    const auto photons =
        traced({{ball, other}, {std::make_shared<ConstantEnvironment>(sky)}, Color::Zero(), nullptr}, {}, 300'000);
    Color sum = Color::Zero();
    for (const Photon& photon : photons) {
        if (photon.point.x() < 4) sum += photon.power;
    }
    // The other ball hides a little of the sky: less than (0.2/1.1)²/4.
    EXPECT_GT((sum / (pi * sky * 4 * pi * 0.49)).minCoeff(), 0.97);
    EXPECT_LT((sum / (pi * sky * 4 * pi * 0.49)).maxCoeff(), 1.02);
}

// Roulette and splitting bring the same by each of the three ways.
TEST(PhotonPower, IsTheSameSplitOrNot) {
    const SceneDescription scene = room({coneLight()}, {glassBall({6.2, -2.4, 2.6}, 0.25, 1.5)});
    Color sums[2][3];
    for (int splits : {0, 1}) {
        for (Color& sum : sums[splits]) sum = Color::Zero();
        for (const Photon& photon : traced(scene, {{60, 1}, 4 * splits}, 60'000))
            sums[splits][static_cast<int>(photon.way)] += photon.power;
    }
    for (int way = 0; way < 3; ++way) expectWithin(sums[0][way], sums[1][way], 0.04);
}

// E of a point light on a floor, by either rule and with the filter, at several places. 30 maps: Poisson's noise of
// about 100 photons each, five standard errors.
TEST(PhotonDensity, IsTheIrradianceOfAFloor) {
    const Vec3 lamp(3, 2, -1);
    SceneObject floor = diffuseRectangle({-20, 0, -20}, {0, 0, 40}, {40, 0, 0}, rho);
    const Scene scene(
        {{floor}, {std::make_shared<ConeLight>(lamp, -Vec3::UnitY(), 0.6, intensity)}, Color::Zero(), nullptr});
    const LightChoice lights(scene.lights());
    const std::vector<DensitySettings> ways = {
        {.nearest = 100, .radius = 1}, {.nearest = {}, .radius = 0.2}, {.nearest = 100, .radius = 1, .cone = 1}};
    for (const Vec3& target : {Vec3(3, 0, -1), Vec3(3.4, 0, -0.8)}) {
        MediumStack media;
        Color passed;
        RayCounts counts;
        const Interaction at = *scene.follow({target + Vec3(0, 1, 0), -Vec3::UnitY()}, media, passed, counts);
        const Color expected = rho / pi * intensity * 2 / std::pow((lamp - target).norm(), 3);
        for (const DensitySettings& way : ways) {
            Color sum = Color::Zero();
            constexpr int maps = 30;
            for (int i = 0; i < maps; ++i)
                sum +=
                    PhotonMap(tracePhotons(scene, lights, sampler, {}, 5000 * i, 5000, 2, counts)).radiance(at, way) /
                    maps;
            expectWithin(sum, expected, 0.1);
        }
    }
}

// Photons of a wall that stands on a floor don't light the floor; those of a gentle slope do.
TEST(PhotonDensity, IsThatOfOneSurface) {
    const Scene scene({{diffuseRectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, rho)}, {}, Color::Zero(), nullptr});
    MediumStack media;
    Color passed;
    RayCounts counts;
    const Interaction at = *scene.follow({Vec3(0, 0, 1), -Vec3::UnitZ()}, media, passed, counts);
    const auto photon = [](const Vec3& ng) {
        return Photon{Vec3(0.1, 0, 0), Vec3(0.6, 0, 0.8), Color::Ones(), ng, 1, PhotonWay::Direct};
    };
    const std::vector<Photon> photons = {photon(Vec3::UnitZ()), photon(Vec3(0.6, 0, 0.8)), photon(Vec3::UnitX()),
                                         photon(-Vec3::UnitZ())};
    EXPECT_EQ(PhotonMap(photons).neighbours(at, {.nearest = {}, .radius = 1}).photons.size(), 2U);
}

Color along(const Integrator& integrator, const Ray& ray, int paths) {
    Color sum = Color::Zero();
    RayCounts counts;
    for (int i = 0; i < paths; ++i)
        sum += integrator.Li(ray, integrator.scene().mediaAt(ray.origin), sampler.start(0, {0, 0}, i), counts);
    return sum / paths;
}

// Path tracing and photons show the same of a coloured room with a mirror ball and an absorbing glass ball in it,
// within what blur does.
TEST(PhotonMapping, ShowsWhatPathTracingShows) {
    SceneObject tinted = glassBall({6.6, -2.6, 2.5}, 0.25, 1.4);
    tinted.interior->medium = std::make_shared<AbsorbingMedium>(Color(0.3, 2, 1));
    const SceneObject lamp = rectangleLamp({5.5, -2.001, 2.5}, {0.7, 0, 0}, {0, 0, 0.4}, Color(7, 3, 1));
    const Scene scene(room({}, {lamp, mirrorBall({5.7, -2.6, 3}, 0.2), tinted}));
    const PathTracer tracer(scene, sampler, filter, {{30, 3}, Direct::Mis});
    std::vector<PhotonMapper> mappers;
    for (const MapUse use : {MapUse::Everything, MapUse::Indirect, MapUse::Gather}) {
        PhotonMapperSettings settings = {.photons = 200'000, .limits = {30, 3}, .use = use};
        settings.density = {.nearest = 300, .radius = 0.2};
        settings.caustics = {.nearest = 100, .radius = 0.1};
        mappers.emplace_back(scene, sampler, filter, settings, 2);
    }
    const Vec3 eye(5.2, -2.2, 2.3);
    for (const Vec3& target :
         {Vec3(7.3, -2.4, 2.9), Vec3(6, -2.6, 3.4), Vec3(5.72, -2.52, 2.85), Vec3(6.6, -2.55, 2.4)}) {
        const Ray ray = {eye, (target - eye).normalized()};
        const Color expected = along(tracer, ray, 20'000);
        for (const PhotonMapper& mapper : mappers) {
            const Color found = along(mapper, ray, 100);
            EXPECT_LE((found - expected).abs().maxCoeff() / expected.maxCoeff(), 0.12)
                << "found " << found.transpose() << ", expected " << expected.transpose();
        }
    }
}

// What doesn't need photons gets none; without delta lobes there are no caustics.
TEST(PhotonMapping, DoesNoMoreThanTheSceneNeeds) {
    const Scene diffuse(DiffuseBox{}.scene(8, 8));
    PhotonMapper plain(diffuse, sampler, filter, {.photons = 500}, 1);
    EXPECT_GT(plain.map().size(), 0U);
    EXPECT_EQ(plain.caustics().size(), 0U);
    EXPECT_EQ(plain.photonCounts().crossings, 0);
    EXPECT_EQ(plain.photonCounts().shadowRays, 0);
    EXPECT_TRUE(plain.whyNoPhotons().empty());
    const Scene glass(peersBox(8, 8));
    EXPECT_GT(PhotonMapper(glass, sampler, filter, {.photons = 500}, 1).caustics().size(), 0U);
    EXPECT_EQ(PhotonMapper(glass, sampler, filter, {.photons = 500, .use = MapUse::Everything}, 1).caustics().size(),
              0U);
}

// The same picture, bit for bit, for any number of threads.
TEST(PhotonMapping, GivesTheSameForAnyThreads) {
    const Scene scene(peersBox(12, 12));
    for (const MapUse use : {MapUse::Everything, MapUse::Indirect, MapUse::Gather}) {
        std::vector<Image> pictures;
        for (const int threads : {1, 2, 3}) {
            PhotonMapper mapper(scene, sampler, filter, {.photons = 5000, .splits = 2, .use = use, .gatherRays = 4},
                                threads);
            pictures.push_back(render(mapper, {.passes = 2, .threads = threads}).film.image());
        }
        for (int y = 0; y < 12; ++y) {
            for (int x = 0; x < 12; ++x) {
                ASSERT_TRUE((pictures[0].at(x, y) == pictures[1].at(x, y)).all());
                ASSERT_TRUE((pictures[0].at(x, y) == pictures[2].at(x, y)).all());
            }
        }
    }
}

}  // namespace
}  // namespace caustic
