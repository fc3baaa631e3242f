#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/pinhole_camera.h"
#include "integrator/camera_connection.h"
#include "integrator/vertex_connection.h"
#include "material/diffuse_material.h"
#include "medium/absorbing_medium.h"
#include "mesh/triangle_mesh.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(1);
const PathNumbers numbers = sampler.start(1, {0, 0}, 0);

std::shared_ptr<const Material> diffuse(Real reflectance) {
    return std::make_shared<DiffuseMaterial>(Color::Constant(reflectance));
}

SceneObject floor(Real reflectance) {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = diffuse(reflectance)};
}

SceneObject ceiling(Real reflectance) {
    return {.shape = std::make_shared<Plane>(Vec3(0, 3, 0), -Vec3::UnitY()), .material = diffuse(reflectance)};
}

Interaction meet(const Scene& scene, const Vec3& from, const Vec3& towards) {
    MediumStack media;
    Color passed;
    RayCounts counts;
    return *scene.follow({from, (towards - from).normalized()}, media, passed, counts);
}

// At (1, 2, 0), looking at the origin.
std::shared_ptr<const Camera> camera() {
    return std::make_shared<PinholeCamera>(Vec3(1, 2, 0), Vec3::Zero(), Vec3::UnitY(), 0.8, 20, 10);
}

// A floor that a mesh makes smooth: its shading normal leans, the same everywhere.
SceneObject leaningFloor(const Vec3& ns) {
    MeshData mesh;
    mesh.positions = {{-9, 0, -9}, {0, 0, 9}, {9, 0, -9}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {ns};
    mesh.normalCorners = {{0, 0, 0}};
    return {.shape = std::make_shared<TriangleMesh>(mesh), .material = diffuse(0.6)};
}

// β f cos θ We cos θ' / d², with We = 1/(pixel's area at distance 1 · cos⁴ θ') for a pinhole. On a smooth mesh a path
// from a light brings f |wo·ns| |wi·ng| / |wo·ng| (Veach 5.3.2).
TEST(CameraConnection, BringsWhatThePixelSees) {
    const Vec3 ns = Vec3(0.3, 1, 0.1).normalized();
    for (const bool smooth : {false, true}) {
        const Scene scene({{smooth ? leaningFloor(ns) : floor(0.6)}, {}, Color::Zero(), camera()});
        const Vec3 point(0.1, 0, 0.2);
        const Vec3 from(-1, 1.5, 0.4);
        const Interaction at = meet(scene, from, point);
        RayCounts counts;
        const auto seen = connectToCamera(scene, at, Color(1, 2, 3), 0, numbers, counts);
        ASSERT_TRUE(seen);
        const Vec3 wi = (Vec3(1, 2, 0) - point).normalized();
        const Vec3 wo = (from - point).normalized();
        const Real atLens = wi.dot(Vec3(1, 2, 0).normalized());
        const Real pixel = std::pow(2 * std::tan(0.4) / 10, 2);
        const Real leaving = smooth ? wo.dot(ns) * wi.y() / wo.y() : wi.y();
        const Real squared = (Vec3(1, 2, 0) - point).squaredNorm();
        const Color expected = Color(1, 2, 3) * (0.6 / pi * leaving / (pixel * std::pow(atLens, 3)) / squared);
        EXPECT_LE((seen->value / expected - 1).abs().maxCoeff(), 1e-9)
            << "Two cosines, the square of the distance, We: are all there? Is f asked for what a path from a light "
               "carries?";
        // Along the view is the film's middle.
        EXPECT_LE((scene.camera().sampleRay(seen->camera.film, {0.5, 0.5}).direction + wi).norm(), 1e-9);
    }
}

// Nothing from behind a wall, from beside the film, from the floor's back; through a tinted pane e^(−σ d).
TEST(CameraConnection, AsksWhatIsInTheWay) {
    RayCounts counts;
    const Scene open({{floor(0.6)}, {}, Color::Zero(), camera()});
    const Interaction at = meet(open, {-1, 1, 0}, {0, 0, 0});
    const auto clear = connectToCamera(open, at, Color::Ones(), 0, numbers, counts);
    ASSERT_TRUE(clear);
    const Interaction beside = meet(open, {-8, 1, 0}, {-7, 0, 0});
    EXPECT_FALSE(connectToCamera(open, beside, Color::Ones(), 0, numbers, counts)) << "Is it on the film?";
    const Interaction below = meet(open, {0, -1, 0}, {0, 0, 0});
    EXPECT_FALSE(connectToCamera(open, below, Color::Ones(), 0, numbers, counts)) << "Does light go through the floor?";

    SceneObject pane;
    pane.shape = std::make_shared<Box>(Vec3(-9, 1, -9), Vec3(9, 1.5, 9));
    pane.interior = Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(1.2)), 0};
    const Scene tinted({{floor(0.6), pane}, {}, Color::Zero(), camera()});
    const Interaction behind = meet(tinted, {-0.5, 0.5, 0}, {0, 0, 0});
    const auto weaker = connectToCamera(tinted, behind, Color::Ones(), 0, numbers, counts);
    ASSERT_TRUE(weaker);
    const Real way = 0.5 / (2 / std::sqrt(5.0));
    EXPECT_NEAR(weaker->value.x() / clear->value.x(), std::exp(-1.2 * way), 1e-9) << "What does the pane let pass?";

    SceneObject wall = floor(0.6);
    wall.shape = pane.shape;
    const Scene dark({{floor(0.6), wall}, {}, Color::Zero(), camera()});
    const auto nothing =
        connectToCamera(dark, meet(dark, {-0.5, 0.5, 0}, {0, 0, 0}), Color::Ones(), 0, numbers, counts);
    EXPECT_TRUE(!nothing || (nothing->value == 0).all()) << "Is there a wall between?";
}

// β f cos θ cos θ' / d² f' β': the geometry term between a floor and a ceiling.
TEST(VertexConnection, HasTheGeometryTerm) {
    const Scene scene({.objects = {floor(0.6), ceiling(0.4)}});
    for (const Real x : {0.0, 1.0, 4.0}) {
        const Interaction eye = meet(scene, {1, 1, 1}, {0, 0, 0});
        const Interaction light = meet(scene, {0.5, 1, 0.5}, {x, 3, 0});
        RayCounts counts;
        const Color betaEye(1, 2, 3);
        const Color betaLight(5, 7, 11);
        const auto joined = connectVertices(scene, {eye, betaEye}, {light, betaLight}, counts);
        ASSERT_TRUE(joined);
        const Real squared = 9 + x * x;
        const Real geometry = 9 / squared / squared;
        const Color expected = betaEye * betaLight * (0.6 / pi * 0.4 / pi * geometry);
        EXPECT_LE((joined->value / expected - 1).abs().maxCoeff(), 1e-9) << "Two cosines over the distance squared?";
        EXPECT_LE((joined->wi - Vec3(x, 3, 0).normalized()).norm(), 1e-9) << "From the eye's vertex to the light's?";
        EXPECT_NEAR(joined->squaredDistance, squared, 1e-9);
    }
}

// On a smooth mesh the end of the eye's walk scatters radiance, f |wi·ns|; that of the light's walk importance,
// f |wo·ns| |wi·ng| / |wo·ng| (Veach 5.3.2).
TEST(VertexConnection, ScattersWhatEachWalkCarries) {
    const Vec3 ns = Vec3(0.3, 1, 0.1).normalized();
    const Scene scene({.objects = {leaningFloor(ns), ceiling(0.4)}});
    const Vec3 below(0.2, 0, 0);
    const Vec3 above(1, 3, 0.5);
    const Vec3 from(-1, 1.5, 0.4);
    const Interaction onFloor = meet(scene, from, below);
    const Interaction onCeiling = meet(scene, {0, 1, 0}, above);
    const Vec3 up = (above - below).normalized();
    const Vec3 wo = (from - below).normalized();
    const Real common = 0.6 / pi * 0.4 / pi * up.y() / (above - below).squaredNorm();
    const Color one = Color::Ones();
    RayCounts counts;
    const auto fromEye = connectVertices(scene, {onFloor, one}, {onCeiling, one}, counts);
    ASSERT_TRUE(fromEye);
    EXPECT_NEAR(fromEye->value.x() / (common * up.dot(ns)), 1, 1e-9) << "What does the eye's walk carry?";
    const auto fromLight = connectVertices(scene, {onCeiling, one}, {onFloor, one}, counts);
    ASSERT_TRUE(fromLight);
    EXPECT_NEAR(fromLight->value.x() / (common * wo.dot(ns) * up.y() / wo.y()), 1, 1e-9)
        << "What does the light's walk carry?";
}

// A wall between both ends, or a tinted pane.
TEST(VertexConnection, AsksWhatIsInTheWay) {
    const auto between = std::make_shared<Box>(Vec3(-9, 1, -9), Vec3(9, 1.5, 9));
    const Color one = Color::Ones();
    const auto connect = [&](const Scene& scene) {
        RayCounts counts;
        const Interaction eye = meet(scene, {0.1, 0.5, 0}, {0, 0, 0});
        const Interaction light = meet(scene, {0.1, 2, 0}, {0, 3, 0});
        const auto joined = connectVertices(scene, {eye, one}, {light, one}, counts);
        return joined ? joined->value.x() : 0;
    };
    const Scene open({.objects = {floor(0.6), ceiling(0.4)}});
    SceneObject pane;
    pane.shape = between;
    pane.interior = Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(1.2)), 0};
    const Scene tinted({.objects = {floor(0.6), ceiling(0.4), pane}});
    EXPECT_NEAR(connect(tinted) / connect(open), std::exp(-0.6), 1e-9) << "What does the pane let pass?";
    const Scene dark({.objects = {floor(0.6), ceiling(0.4), {.shape = between, .material = diffuse(0.5)}}});
    EXPECT_EQ(connect(dark), 0) << "Is there a wall between?";
}

}  // namespace
}  // namespace caustic
