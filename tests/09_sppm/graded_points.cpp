#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "integrator/photon_grid.h"
#include "integrator/visible_point.h"
#include "light/constant_environment.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/rough_conductor_material.h"
#include "mesh/triangle_mesh.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(1);
const PathNumbers numbers = sampler.start(0, {0, 0}, 0);
const Color rosy(0.8, 0.5, 0.2);

SceneObject floorOf(const Color& reflectance) {
    return {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()),
            std::make_shared<DiffuseMaterial>(reflectance),
            {},
            nullptr};
}

// At x = 2, facing the origin's side; it reflects channels differently.
SceneObject mirrorWall(const Color& reflectance) {
    return {std::make_shared<Plane>(Vec3(2, 0, 0), -Vec3::UnitX()),
            std::make_shared<MirrorMaterial>(reflectance),
            {},
            nullptr};
}

EyePath look(const Scene& scene, const Vec3& from, const Vec3& towards, int mostSegments = 8) {
    RayCounts counts;
    return findVisiblePoint(scene, {from, (towards - from).normalized()}, {}, {.maxLength = mostSegments}, numbers,
                            counts);
}

// Over a coloured mirror to a floor: where the mirror throws the ray, after two segments, tinted by the mirror.
TEST(VisiblePoint, LiesBehindMirrors) {
    const Scene scene({{floorOf(rosy), mirrorWall(Color(0.9, 0.4, 0.7))}, {}, Color::Zero(), nullptr});
    const EyePath straight = look(scene, {0, 1, 0}, {1, 0, 0.5});
    ASSERT_TRUE(straight.point) << "A diffuse floor is a visible point.";
    EXPECT_LE((straight.point->at.point() - Vec3(1, 0, 0.5)).norm(), 1e-9);
    EXPECT_EQ(straight.point->length, 1);
    EXPECT_TRUE((straight.point->beta == 1).all());

    const EyePath mirrored = look(scene, {0, 1, 0}, {2, 0.5, 0.25});
    ASSERT_TRUE(mirrored.point) << "A mirror is none: does the path go on?";
    EXPECT_LE((mirrored.point->at.point() - Vec3(0, 0, 0.5)).norm(), 1e-9);
    EXPECT_EQ(mirrored.point->length, 2) << "Segments from the eye.";
    EXPECT_LE((mirrored.point->beta - Color(0.9, 0.4, 0.7)).abs().maxCoeff(), 1e-12) << "What the mirror leaves.";
    EXPECT_FALSE(look(scene, {0, 1, 0}, {2, 0.5, 0.25}, 1).point) << "One segment only.";
    EXPECT_FALSE(look(scene, {0, 1, 0}, {-5, 1.5, 0.3}).point) << "There is nothing.";

    const Scene lamp(
        {{rectangleLamp({-3, -9, -9}, {0, 18, 0}, {0, 0, 18}, Color(5, 7, 11))}, {}, Color::Zero(), nullptr});
    EXPECT_FALSE(look(lamp, {0, 1, 0}, {-3, 1.2, 0.3}).point) << "A lamp that reflects nothing is no visible point.";
}

// Whatever scatters into more than single directions is a visible point: brushed metal, too.
TEST(VisiblePoint, MayBeGlossy) {
    const auto brushed = std::make_shared<RoughConductorMaterial>(Metal::copper(), 0.3, 0.3);
    const Scene scene(
        {{{std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), brushed, {}, nullptr}}, {}, Color::Zero(), nullptr});
    EXPECT_TRUE(look(scene, {0, 1, 0}, {1, 0, 0.5}).point) << "Which lobes spread light?";
}

// Lamps that the path meets: one seen over the mirror, one that is a diffuse surface itself, and the sky; each once,
// and nothing of those that nobody sees.
TEST(VisiblePoint, SeesTheLampsOnTheWay) {
    // Behind the eye, so that it is seen in the mirror alone.
    const SceneObject lamp = rectangleLamp({-3, -9, -9}, {0, 18, 0}, {0, 0, 18}, Color(5, 7, 11));
    SceneObject shining = lamp;
    shining.material = std::make_shared<DiffuseMaterial>(rosy);
    const Color tint(0.9, 0.4, 0.7);
    const Scene scene({{lamp, mirrorWall(tint)}, {}, Color::Zero(), nullptr});
    const EyePath dark = look(scene, {0, 1, 0}, {2, 1.2, 0.3});
    EXPECT_LE((dark.seen - tint * Color(5, 7, 11)).abs().maxCoeff(), 1e-9) << "The lamp, as the mirror shows it.";

    const Scene bright({{shining, mirrorWall(tint)}, {}, Color::Zero(), nullptr});
    const EyePath both = look(bright, {0, 1, 0}, {2, 1.2, 0.3});
    EXPECT_TRUE(both.point) << "A lamp may scatter light, too.";
    EXPECT_LE((both.seen - tint * Color(5, 7, 11)).abs().maxCoeff(), 1e-9);

    // From the floor any way on would see the sky.
    const Scene open(
        {{floorOf(rosy)}, {std::make_shared<ConstantEnvironment>(Color(1, 2, 3))}, Color::Zero(), nullptr});
    const EyePath floor = look(open, {0, 1, 0}, {1, 0, 0.5});
    ASSERT_TRUE(floor.point);
    EXPECT_EQ(floor.seen.maxCoeff(), 0) << "Does the path go on from its visible point?";
    const EyePath sky = look(open, {0, 1, 0}, {1, 2, 0.5});
    EXPECT_LE((sky.seen - Color(1, 2, 3)).abs().maxCoeff(), 1e-12) << "Where nothing is met, the sky is seen.";
}

// A floor that a mesh makes smooth: its shading normal leans.
SceneObject leaningFloor(const Vec3& ns, std::shared_ptr<const Material> material) {
    MeshData mesh;
    mesh.positions = {{-9, 0, -9}, {0, 0, 9}, {9, 0, -9}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {ns};
    mesh.normalCorners = {{0, 0, 0}};
    return {std::make_shared<TriangleMesh>(mesh), std::move(material), {}, nullptr};
}

Photon photon(const Vec3& point, const Vec3& wi, const Color& power, int length) {
    return {.point = point, .wi = wi.normalized(), .power = power, .length = length};
}

// Σ f Φ |wi·ns|/|wi·ng| over the photons within the radius, on a smooth, glossy, coloured floor seen over a mirror.
TEST(Gather, SumsWhatPhotonsScatterToTheEye) {
    const Vec3 ns = Vec3(0.3, 1, 0.1).normalized();
    const auto phong =
        std::make_shared<PhongMaterial>(std::make_shared<ConstantTexture>(rosy * 0.5), Color(0.2, 0.1, 0.3), 12);
    const Scene scene({{leaningFloor(ns, phong), mirrorWall(Color(0.9, 0.4, 0.7))}, {}, Color::Zero(), nullptr});
    const EyePath path = look(scene, {0, 1, 0}, {2, 0.5, 0.25});
    ASSERT_TRUE(path.point);
    const Interaction& at = path.point->at;
    Random random(8, {1});
    std::vector<Photon> photons;
    Color expected = Color::Zero();
    std::int64_t count = 0;
    constexpr Real radius = 0.2;
    for (int i = 0; i < 500; ++i) {
        const Vec3 place = at.point() + Vec3(random.uniform(-0.4, 0.4), 0, random.uniform(-0.4, 0.4));
        const Vec3 wi = Vec3(random.uniform(-1, 1), random.uniform(0.3, 1), random.uniform(-1, 1)).normalized();
        const Color power(random.uniform(), random.uniform(), random.uniform());
        photons.push_back(photon(place, wi, power, 2));
        if ((place - at.point()).norm() > radius) continue;
        const Color f = at.f(wi, TransportMode::Radiance);
        if ((f == 0).all()) continue;
        ++count;
        expected += f * power * (std::abs(wi.dot(ns)) / wi.y());
    }
    ASSERT_GT(count, 50);
    const Gathered found = PhotonGrid(photons, radius).gather(*path.point, radius, 8);
    EXPECT_EQ(found.photons, count) << "Which photons are within the radius?";
    EXPECT_LE((found.flux / expected - 1).abs().maxCoeff(), 1e-9)
        << "f times power; and photons are as dense as ng says, while f belongs to the cosine of ns. The path's own "
           "throughput comes later.";
}

// Photons on the other side of a thin wall, and those that come from behind a corner: they don't light this side, and
// must not count, or a point would shrink its radius for them.
TEST(Gather, LeavesOutPhotonsFromBehind) {
    const Scene scene({{floorOf(rosy)}, {}, Color::Zero(), nullptr});
    const EyePath path = look(scene, {0, 1, 0}, {0.3, 0, 0.2});
    ASSERT_TRUE(path.point);
    const Vec3 point = path.point->at.point();
    const std::vector<Photon> photons = {photon(point, {0.3, 1, 0}, Color::Ones(), 2),
                                         photon(point, {0.3, -1, 0}, Color::Ones(), 2),
                                         photon(point + Vec3(0.01, -1e-3, 0), {0, -0.2, 1}, Color::Ones(), 2)};
    const Gathered found = PhotonGrid(photons, 0.1).gather(*path.point, 0.1, 8);
    EXPECT_EQ(found.photons, 1) << "Does the floor scatter what comes from below?";
    EXPECT_LE((found.flux - rosy / pi).abs().maxCoeff(), 1e-9);
    // A floor that keeps red light to itself is lit all the same.
    const Color green(0, 0.5, 0.2);
    const Scene other({{floorOf(green)}, {}, Color::Zero(), nullptr});
    const EyePath same = look(other, {0, 1, 0}, {0.3, 0, 0.2});
    ASSERT_TRUE(same.point);
    const Gathered coloured = PhotonGrid(photons, 0.1).gather(*same.point, 0.1, 8);
    EXPECT_EQ(coloured.photons, 1) << "Which photons scatter nothing at all to the eye?";
    EXPECT_LE((coloured.flux - green / pi).abs().maxCoeff(), 1e-9);
}

// Light that takes more segments than a path may have: the eye's and the photon's, together.
TEST(Gather, LeavesOutPathsThatAreTooLong) {
    const Scene scene({{floorOf(rosy), mirrorWall(Color::Ones())}, {}, Color::Zero(), nullptr});
    const EyePath path = look(scene, {0, 1, 0}, {2, 0.5, 0.25});
    ASSERT_TRUE(path.point);
    std::vector<Photon> photons;
    for (int length = 2; length <= 7; ++length)
        photons.push_back(photon(path.point->at.point(), Vec3::UnitY(), Color::Constant(length), length));
    const PhotonGrid grid(photons, 0.1);
    EXPECT_EQ(grid.gather(*path.point, 0.1, 8).photons, 5) << "Two segments from the eye, two to six from the lamp.";
    EXPECT_EQ(grid.gather(*path.point, 0.1, 4).photons, 1) << "Two and two.";
    EXPECT_EQ(grid.gather(*path.point, 0.1, 3).photons, 0);
}

}  // namespace
}  // namespace caustic
