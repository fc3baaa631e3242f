#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "integrator/photon_tracer.h"
#include "light/cone_light.h"
#include "light/point_light.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "material/rough_dielectric_material.h"
#include "medium/absorbing_medium.h"
#include "mesh/triangle_mesh.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "support/coloured_fog.h"
#include "support/varnish.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(5);
const Color intensity(4, 0.7, 2);  // of all lamps, W/sr

std::shared_ptr<const Material> diffuse(const Color& reflectance) {
    return std::make_shared<DiffuseMaterial>(reflectance);
}

SceneDescription describe(std::vector<SceneObject> objects, std::vector<std::shared_ptr<Light>> lights) {
    return {std::move(objects), std::move(lights), Color::Zero(), nullptr};
}

// A lopsided room far from the origin, closed, of a size of your choice, and what it is filled with. The lamp is in a
// corner of it.
struct Room {
    Real size = 1;
    Color reflectance = Color(0.6, 0.3, 0.45);
    std::shared_ptr<const Medium> medium = nullptr;

    Vec3 low() const { return size * Vec3(5, -3, 2); }
    Vec3 high() const { return size * Vec3(7.3, -2, 3.4); }
    Vec3 lamp() const { return size * Vec3(5.4, -2.3, 3.1); }

    SceneDescription description() const {
        SceneObject walls = {std::make_shared<Box>(low(), high()), diffuse(reflectance), {}, nullptr};
        if (medium != nullptr) walls.interior = Interior{1, medium, 0};
        return describe({walls}, {std::make_shared<PointLight>(lamp(), size * size * intensity)});
    }
};

std::vector<Photon> traced(const Scene& scene, const PhotonSettings& settings, std::int64_t count) {
    RayCounts counts;
    return tracePhotons(scene, LightChoice(scene.lights()), sampler, settings, 0, count, 1, counts);
}

Color total(const std::vector<Photon>& photons) {
    Color sum = Color::Zero();
    for (const Photon& photon : photons) sum += photon.power;
    return sum;
}

// Straight, then by mirrors and glass only, then by anything else: once a surface has spread the light nothing makes a
// caustic of it again.
TEST(PhotonWay, IsThatOfTheWholePath) {
    EXPECT_EQ(scatteredWay(PhotonWay::Direct, true), PhotonWay::Caustic);
    EXPECT_EQ(scatteredWay(PhotonWay::Caustic, true), PhotonWay::Caustic) << "Two mirrors are a mirror.";
    EXPECT_EQ(scatteredWay(PhotonWay::Direct, false), PhotonWay::Indirect);
    EXPECT_EQ(scatteredWay(PhotonWay::Caustic, false), PhotonWay::Indirect) << "What has been a caustic before?";
    EXPECT_EQ(scatteredWay(PhotonWay::Indirect, false), PhotonWay::Indirect);
    EXPECT_EQ(scatteredWay(PhotonWay::Indirect, true), PhotonWay::Indirect)
        << "A mirror shows a wall: is that a caustic?";
}

// A mirror ball hangs in the room. Photons stay on the walls, never on the ball, and each knows where it came from.
TEST(Photons, LieWhereLightIsSpread) {
    const Room room;
    SceneDescription description = room.description();
    const Vec3 center(6.4, -2.5, 2.6);
    description.objects.push_back(
        {std::make_shared<Sphere>(center, 0.4), std::make_shared<MirrorMaterial>(Color::Constant(0.9)), {}, nullptr});
    const Scene scene(description);
    int ways[3] = {0, 0, 0};
    for (const Photon& photon : traced(scene, {}, 5000)) {
        ++ways[static_cast<int>(photon.way)];
        EXPECT_GT((photon.point - center).norm(), 0.5) << "Does a photon stay on a mirror?";
        EXPECT_NEAR(photon.wi.norm(), 1, 1e-12);
        EXPECT_GT(photon.wi.dot((room.low() + room.high()) / 2 - photon.point), -2) << "Which way does wi point?";
        EXPECT_EQ(photon.length == 1, photon.way == PhotonWay::Direct);
        if (photon.way != PhotonWay::Direct) continue;
        const Vec3 toLamp = (room.lamp() - photon.point).normalized();
        EXPECT_LE((photon.wi - toLamp).norm(), 1e-9) << "Does wi point to where the light came from?";
    }
    for (const int count : ways) EXPECT_GT(count, 50) << "Does each way have photons?";

    // A floor with smooth normals: what a photon keeps is how the surface lies, not how it is shaded.
    MeshData mesh;
    mesh.positions = {{-9, 0, -9}, {0, 0, 9}, {9, 0, -9}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {Vec3(0.28, 0.96, 0)};
    mesh.normalCorners = {{0, 0, 0}};
    const Scene smooth(describe({{std::make_shared<TriangleMesh>(mesh), diffuse(Color::Ones()), {}, nullptr}},
                                {std::make_shared<ConeLight>(Vec3(0, 1, 0), Vec3(0.2, -1, 0.1), 0.3, intensity)}));
    const std::vector<Photon> few = traced(smooth, {}, 20);
    EXPECT_EQ(few.size(), 20U);
    for (const Photon& photon : few) EXPECT_LE((photon.ng - Vec3::UnitY()).norm(), 1e-12) << "Which normal is kept?";
}

// N photons of a lamp of power Φ bring Φ/N each, whatever the size of the room; through a coloured medium
// e^(−σ d) of it. Of two lamps, the powers of both.
TEST(Photons, BringTheLampsPower) {
    for (const Real size : {1e-6, 1.0, 1e6}) {
        Room room = {size};
        const Color sigma = Color(0.4, 1.3, 0.1) / size;
        for (const bool filled : {false, true}) {
            if (filled) room.medium = std::make_shared<AbsorbingMedium>(sigma);
            const Scene scene(room.description());
            int direct = 0;
            for (const Photon& photon : traced(scene, {}, 1500)) {
                if (photon.way != PhotonWay::Direct) continue;
                ++direct;
                const Real distance = (photon.point - room.lamp()).norm();
                Color expected = 4 * pi * size * size * intensity / 1500;
                if (filled) expected *= (-sigma * distance).exp();
                EXPECT_LE(((photon.power - expected) / expected).abs().maxCoeff(), 1e-9)
                    << "Is a lamp's light shared among all photons that set out? And what has the way taken?";
            }
            EXPECT_EQ(direct, 1500) << "Does each come to a wall, and stay there?";
        }
    }
}

// What direct light is sampled by, photons needn't bring.
TEST(Photons, ThatComeStraightAreLeftOutOnRequest) {
    const Scene scene(Room{}.description());
    std::vector<Photon> all = traced(scene, {.direct = true}, 2000);
    std::erase_if(all, [](const Photon& photon) { return photon.way == PhotonWay::Direct; });
    const std::vector<Photon> rest = traced(scene, {.direct = false}, 2000);
    ASSERT_EQ(rest.size(), all.size()) << "Are those that come straight left out, and only those?";
    EXPECT_LE((total(rest) - total(all)).abs().maxCoeff(), 1e-9 * total(all).maxCoeff());
}

// Where a medium scatters light, there is no surface to stay on.
TEST(Photons, StayOnSurfacesOnly) {
    Room room;
    room.medium = std::make_shared<test::ColouredFog>(Color::Constant(0.1), Color::Constant(1.5));
    const Scene scene(room.description());
    int scattered = 0;
    for (const Photon& photon : traced(scene, {}, 1000)) {
        const Vec3 inside = (photon.point - room.low()).cwiseMin(room.high() - photon.point);
        EXPECT_LE(inside.minCoeff(), 1e-9) << "Does a photon hang in the air?";
        scattered += photon.way == PhotonWay::Indirect;
    }
    EXPECT_GT(scattered, 300) << "Do photons go on from where a medium scatters them?";
    scattered = 0;
    for (const Photon& photon : traced(scene, {.splits = 3}, 500)) scattered += photon.way == PhotonWay::Indirect;
    EXPECT_GT(scattered, 150) << "Where a medium scatters, there are no lobes to split by.";
}

// Under a cone of light lies glass that reflects and lets through what you like; below and above is a diffuse plane.
struct Pane {
    Color reflected = Color(0.3, 0.1, 0.2);
    Color refracted = Color(0.4, 0.8, 0.7);
    Color ceiling = Color(0.2, 0.5, 0.9);

    Scene scene() const {
        SceneObject glass = {std::make_shared<Plane>(Vec3(0, 0, 0), Vec3::UnitY()),
                             std::make_shared<RefractionMaterial>(reflected, refracted), Interior{1.5, nullptr, 0},
                             nullptr};
        SceneObject below = {
            std::make_shared<Plane>(Vec3(0, -1, 0), Vec3::UnitY()), diffuse(Color::Zero()), {}, nullptr};
        SceneObject above = {std::make_shared<Plane>(Vec3(0, 3, 0), -Vec3::UnitY()), diffuse(ceiling), {}, nullptr};
        return Scene(describe({glass, below, above},
                              {std::make_shared<ConeLight>(Vec3(2, 1, 5), Vec3(0.5, -1, 0.2), 0.3, intensity)}));
    }
};

// By roulette each photon goes one of two ways. Split, each goes both, with what the glass gives each colour, and no
// chance is in it.
TEST(Split, EachLobeGetsItsShare) {
    const Pane pane;
    const Scene scene = pane.scene();
    const Color each = 2 * pi * (1 - std::cos(0.3)) * intensity / 700;
    int up = 0;
    int down = 0;
    for (const Photon& photon : traced(scene, {.limits = {2, 1}, .splits = 1}, 700)) {
        if (std::abs(photon.point.y()) < 0.5) continue;
        EXPECT_EQ(photon.length, 2) << "Does the part know how far it has come?";
        const bool above = photon.point.y() > 0;
        ++(above ? up : down);
        EXPECT_LE((photon.power - each * (above ? pane.reflected : pane.refracted)).abs().maxCoeff(), 1e-12)
            << "Is a lobe's share that of the glass, or is something divided by a probability?";
    }
    EXPECT_EQ(up, 700) << "Does every photon go on by reflection?";
    EXPECT_EQ(down, 700) << "Does every photon go on by refraction?";
    int unsplit = 0;
    for (const Photon& photon : traced(scene, {.limits = {2, 9}, .splits = 0}, 700))
        unsplit += std::abs(photon.point.y()) > 0.5;
    EXPECT_LE(unsplit, 700) << "Without a split each goes one way. After how many vertices is none split any more?";
}

// Between two black planes lies a surface of your choice, under a cone of light.
Scene between(std::shared_ptr<const Material> material, std::optional<Interior> interior) {
    const SceneObject surface = {std::make_shared<Plane>(Vec3(0, 0, 0), Vec3::UnitY()), std::move(material),
                                 std::move(interior), nullptr};
    const auto black = [](Real y) -> SceneObject {
        return {std::make_shared<Plane>(Vec3(0, y, 0), Vec3::UnitY()), diffuse(Color::Zero()), {}, nullptr};
    };
    return Scene(describe({surface, black(-1), black(3)},
                          {std::make_shared<ConeLight>(Vec3(2, 1, 5), Vec3(0.5, -1, 0.2), 0.3, intensity)}));
}

// A surface that spreads light sends a split photon on into one direction, with what it reflects.
TEST(Split, SurfacesThatSpreadLightSendItOnOnce) {
    const Room room;
    const Scene scene(room.description());
    int lengths[5] = {};
    for (const Photon& photon : traced(scene, {.limits = {4, 9}, .splits = 2}, 600)) {
        ++lengths[photon.length];
        const Color expected = 4 * pi * intensity / 600 * room.reflectance.pow(photon.length - 1);
        EXPECT_LE((photon.power - expected).abs().maxCoeff(), 1e-12) << "What does a diffuse surface leave of it?";
        EXPECT_EQ(photon.way, photon.length > 1 ? PhotonWay::Indirect : PhotonWay::Direct);
    }
    for (int length = 1; length <= 4; ++length) EXPECT_EQ(lengths[length], 600) << "length " << length;

    // One may mirror light and spread it: then the mirrored part is one, whatever is sampled for the other.
    const Color mirrored(0.3, 0.1, 0.2);
    const Color spread(0.5, 0.8, 0.1);
    const Color each = 2 * pi * (1 - std::cos(0.3)) * intensity / 700;
    int parts[2] = {};
    const Scene varnished = between(std::make_shared<test::VarnishMaterial>(mirrored, spread), {});
    for (const Photon& photon : traced(varnished, {.limits = {2, 9}, .splits = 1}, 700)) {
        if (photon.length == 1) continue;
        const bool byMirror = photon.way == PhotonWay::Caustic;
        ++parts[byMirror ? 1 : 0];
        const Color expected = each * (byMirror ? mirrored : Color(spread / 0.6));
        EXPECT_LE((photon.power - expected).abs().maxCoeff(), 1e-12) << (byMirror ? "mirrored" : "spread");
    }
    EXPECT_EQ(parts[1], 700) << "Does the mirrored part set out once more when a sample happens to be mirrored?";
    EXPECT_NEAR(parts[0], 420, 60) << "Of ten samples six are spread. What if there is none?";
}

// Nearly all light that meets rough glass goes on; radiance, which is denser in glass, is another matter.
TEST(Split, RoughGlassKeepsThePower) {
    const Scene glass = between(std::make_shared<RoughDielectricMaterial>(0.2, 0.2), Interior{1.5, nullptr, 0});
    Color sum = Color::Zero();
    for (const Photon& photon : traced(glass, {.limits = {2, 9}, .splits = 1}, 700))
        if (photon.length == 2) sum += photon.power;
    const Color share = sum / (2 * pi * (1 - std::cos(0.3)) * intensity);
    EXPECT_GT(share.minCoeff(), 0.95) << "A photon is power. Which mode carries it?";
    EXPECT_LT(share.maxCoeff(), 1.001);
}

// Parts go different ways from where they arrive: each has numbers of its own. On the inside of a sphere a chord leaves
// and arrives at the same angle, so angles tell which photons have chosen the same direction.
TEST(Split, PartsHaveNumbersOfTheirOwn) {
    SceneObject glass = {std::make_shared<Plane>(Vec3(0, 0, 0), Vec3::UnitY()),
                         std::make_shared<RefractionMaterial>(Color::Constant(0.5), Color::Constant(0.5)),
                         Interior{1.5, nullptr, 0}, nullptr};
    SceneObject around = {std::make_shared<Sphere>(Vec3::Zero(), 10), diffuse(Color::Constant(0.9)), {}, nullptr};
    const Scene scene(
        describe({glass, around}, {std::make_shared<ConeLight>(Vec3(2, 1, 0), Vec3(0.5, -1, 0.2), 0.3, intensity)}));
    std::vector<Real> cosines;
    for (const Photon& photon : traced(scene, {.limits = {3, 9}, .splits = 1}, 500)) {
        if (photon.length == 3) cosines.push_back(std::abs(photon.wi.dot(photon.point)) / 10);
    }
    ASSERT_GT(cosines.size(), 100U);
    std::sort(cosines.begin(), cosines.end());
    for (std::size_t i = 1; i < cosines.size(); ++i)
        EXPECT_GT(cosines[i] - cosines[i - 1], 1e-9) << "Do both parts use the same numbers?";

    // One after the other: the numbers of a split have been used when its parts go on.
    around.material = diffuse(Color::Ones());
    const Scene alone(
        describe({around}, {std::make_shared<ConeLight>(Vec3(2, 1, 0), Vec3(0.5, -1, 0.2), 0.3, intensity)}));
    cosines.clear();
    for (const Photon& photon : traced(alone, {.limits = {5, 9}, .splits = 2}, 200)) {
        if (photon.length > 1) cosines.push_back(std::abs(photon.wi.dot(photon.point)) / 10);
    }
    ASSERT_EQ(cosines.size(), 800U);
    std::sort(cosines.begin(), cosines.end());
    for (std::size_t i = 1; i < cosines.size(); ++i)
        EXPECT_GT(cosines[i] - cosines[i - 1], 1e-10) << "Does a part use numbers once more?";
}

// No way is longer than the longest, split or not, and nobody follows a photon further than that.
TEST(Split, EndsWhereWaysEnd) {
    const Scene scene(Room{}.description());
    for (const int longest : {1, 2, 3}) {
        RayCounts counts;
        const auto photons = tracePhotons(scene, LightChoice(scene.lights()), sampler,
                                          {.limits = {longest, 9}, .splits = 5}, 0, 400, 1, counts);
        EXPECT_EQ(photons.size(), 400U * static_cast<std::size_t>(longest)) << "Where does a split photon end?";
        EXPECT_EQ(counts.rays, 400 * longest) << "Is a photon followed in vain?";
    }
}

}  // namespace
}  // namespace caustic
