#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include "camera/pinhole_camera.h"
#include "integrator/camera_connection.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "vertex_scenes.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const PathNumbers numbers = test::independent.start(1, {0, 0}, 0);

Scene seenBy(const std::vector<SceneObject>& objects, const std::shared_ptr<const Camera>& camera) {
    return Scene({objects, {}, Color::Zero(), camera});
}

// At (1, 2, 0), looking at the origin; all of it a size larger, and moved.
std::shared_ptr<const Camera> camera(Real size = 1, const Vec3& offset = Vec3::Zero()) {
    return std::make_shared<PinholeCamera>(size * (offset + Vec3(1, 2, 0)), size * offset, Vec3::UnitY(), 0.8, 20, 10);
}

Color connected(const Scene& scene, const Interaction& at, const Color& beta = Color::Ones()) {
    RayCounts counts;
    const auto seen = connectToCamera(scene, at, beta, 0, numbers, counts);
    EXPECT_TRUE(seen) << "Is light lost that gets to the camera?";
    return seen ? seen->value : Color::Zero();
}

void expectNothing(const Scene& scene, const Interaction& at, const char* question) {
    RayCounts counts;
    EXPECT_FALSE(connectToCamera(scene, at, Color::Ones(), 0, numbers, counts)) << question;
}

// We cos θ' / d² of that camera, of size 1, at a point.
Real lens(const Vec3& point) {
    const Vec3 way = Vec3(1, 2, 0) - point;
    const Real cosine = way.normalized().dot(Vec3(1, 2, 0).normalized());
    const Real pixel = std::pow(2 * std::tan(0.4) / 10, 2);
    return 1 / (pixel * std::pow(cosine, 3)) / way.squaredNorm();
}

// β f cos θ We cos θ' / d², with We = 1/(pixel's area at distance 1 · cos⁴ θ') for a pinhole. On a smooth mesh a path
// from a light brings f |wo·ns| |wi·ng| / |wo·ng| (Veach 5.3.2). In a medium there is no cosine.
TEST(CameraConnection, BringsWhatThePixelSees) {
    const Vec3 point(0.1, 0, 0.2);
    const Vec3 from(-1, 1.5, 0.4);
    const Vec3 offset(5, -3, 2);
    const Vec3 wi = (Vec3(1, 2, 0) - point).normalized();
    const Vec3 wo = (from - point).normalized();
    const Color beta(1, 2, 3);
    for (const Real size : test::sizes) {
        for (const Vec3& ns : {Vec3(0, 1, 0), Vec3(Vec3(0.3, 1, 0.1).normalized())}) {
            const SceneObject floor = {
                test::leaningPlane(size * offset, Vec3::UnitY(), ns, 9 * size), test::diffuse(test::rho), {}, nullptr};
            const Scene scene = seenBy({floor}, camera(size, offset));
            const Interaction at = test::meet(scene, size * (offset + from), size * (offset + point));
            RayCounts counts;
            const auto seen = connectToCamera(scene, at, beta, 0, numbers, counts);
            ASSERT_TRUE(seen) << "Where does the shadow ray start, and where does it end?";
            const Real leaving = wo.dot(ns) * wi.y() / wo.y();
            test::expectColor(seen->value * (size * size), beta * test::rho / pi * leaving * lens(point),
                              "Two cosines, the square of the distance, We: are all there? Is f asked for what a path "
                              "from a light carries?");
            // Along the view is the film's middle.
            EXPECT_LE((scene.camera().sampleRay(seen->camera.film, {0.5, 0.5}).direction + wi).norm(), 1e-9);
            EXPECT_LE((seen->camera.wi - wi).norm(), 1e-9) << "Is what the camera said handed on?";
        }
    }
    const test::ForwardPhase phase;
    const Scene empty = seenBy({}, camera());
    const Real p = (1 - wo.dot(wi) / 2) / (4 * pi);
    test::expectColor(connected(empty, Interaction(point, wo, phase, {}), beta), beta * p * lens(point),
                      "What takes the place of f and of the cosine where a medium scatters?");
}

// Nothing from behind a wall, from beside the film, from the floor's back, from a black floor; from one that lacks a
// colour the others. What is behind the camera is not in the way.
TEST(CameraConnection, AsksWhatIsInTheWay) {
    const SceneObject floor = test::floorAt(0, test::rho);
    const Scene open = seenBy({floor}, camera());
    const Interaction at = test::meet(open, {-1, 1, 0}, {0, 0, 0});
    const Color clear = connected(open, at);
    expectNothing(open, test::meet(open, {-8, 1, 0}, {-7, 0, 0}), "Is it on the film?");
    expectNothing(open, test::meet(open, {0, -1, 0}, {0, 0, 0}), "Does light go through the floor?");
    const Scene black = seenBy({test::floorAt(0, Color::Zero())}, camera());
    expectNothing(black, test::meet(black, {-1, 1, 0}, {0, 0, 0}), "Does a black floor scatter anything?");
    for (const Color& channels : {Color(0.8, 0, 0.3), Color(0, 0.5, 0.3), Color(0.8, 0.5, 0)}) {
        const Scene scene = seenBy({test::floorAt(0, channels)}, camera());
        test::expectColor(connected(scene, test::meet(scene, {-1, 1, 0}, {0, 0, 0})), clear * channels / test::rho,
                          "Does light end when one of its colours does?");
    }

    const auto wall = [](Real height) {
        return SceneObject{std::make_shared<Rectangle>(Vec3(-9, height, -9), Vec3(18, 0, 0), Vec3(0, 0, 18)),
                           test::diffuse(test::rho),
                           {},
                           nullptr};
    };
    const Scene dark = seenBy({floor, wall(1.2)}, camera());
    expectNothing(dark, test::meet(dark, {-0.5, 0.5, 0}, {0, 0, 0}), "Is there a wall between?");
    const Scene under = seenBy({floor, wall(2.1)}, camera());
    test::expectColor(connected(under, test::meet(under, {-1, 1, 0}, {0, 0, 0})), clear,
                      "Where does the shadow ray end: at the lens, or at what is behind the camera?");

    for (const Real size : test::sizes) {
        const SceneObject ball = {
            std::make_shared<Sphere>(Vec3(0, -size, 0), size), test::diffuse(test::rho), {}, nullptr};
        const Scene scene = seenBy({ball}, camera(size));
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = size * Vec3(0.3 * std::cos(i), 2, 0.3 * std::sin(2.0 * i));
            EXPECT_GT(connected(scene, test::meet(scene, from, {0, -0.5 * size, 0})).minCoeff(), 0)
                << "Where does the shadow ray start? Does the ball shade itself?";
        }
    }
}

// Through tinted air e^(−σ d), in each colour, up to the lens and no further. Paper around tinted air lets light out:
// what the shadow ray starts in depends on the side that it goes to.
TEST(CameraConnection, IsAbsorbedOnItsWay) {
    const Scene open = seenBy({test::floorAt(0, test::rho)}, camera());
    const Color clear = connected(open, test::meet(open, {-1, 1, 0}, {0, 0, 0}));
    for (const auto& [low, high] :
         {std::pair(0.5, 1.5), std::pair(-5.0, 1.5), std::pair(-5.0, 9.0), std::pair(0.5, 9.0)}) {
        const Color thick(5000, 0.1, 0.7);
        const Scene tinted =
            seenBy({test::floorAt(0, test::rho), test::tintedAir({-9, low, -9}, {9, high, 9}, thick)}, camera());
        const Real way = (std::min(2.0, high) - std::max(0.0, low)) * std::sqrt(5.0) / 2;
        Color expected = clear * (-thick * way).exp();
        expected.x() = 0;
        test::expectColor(connected(tinted, test::meet(tinted, {-0.5, 0.2, 0}, {0, 0, 0})), expected,
                          "What is between the floor and the lens?");
    }
    const Color through(0.2, 0.3, 0.4);
    for (const bool eyeInside : {false, true}) {
        // The top of the lantern, seen from above or from within.
        const Vec3 lensPoint(0, eyeInside ? 0.5 : 2, 0);
        const auto eye = std::make_shared<PinholeCamera>(lensPoint, Vec3(0, 1, 0), Vec3::UnitX(), 0.8, 20, 10);
        const Scene scene = seenBy({test::lantern(through, test::rho)}, eye);
        const Scene floor = seenBy({test::floorAt(1, Color::Ones())}, eye);
        const Color white = connected(floor, test::meet(floor, {0, eyeInside ? 0.7 : 1.5, 0}, {0, 1, 0}));
        for (const bool lightInside : {false, true}) {
            const Color value = connected(scene, test::meet(scene, {0, lightInside ? 0.2 : 3, 0}, {0, 1, 0}));
            Color expected = white * (eyeInside == lightInside ? test::rho : through);
            if (eyeInside) expected *= (-0.5 * test::sigma).exp();
            test::expectColor(value, expected, "On which side of the surface does the shadow ray start?");
        }
    }
}

// A square lens of a width: where on it a vertex is seen through, two numbers say. The film sees straight ahead.
class LensCamera final : public Camera {
public:
    int width() const override { return 20; }
    int height() const override { return 10; }
    bool hasLens() const override { return true; }
    Ray sampleRay(const Vec2&, const Vec2& lens) const override { return {lensPoint(lens), -Vec3::UnitY()}; }
    std::optional<ImportanceSample> sampleImportance(const Vec3& point, const Vec2& lens) const override {
        asked.push_back(lens);
        const Vec3 way = lensPoint(lens) - point;
        const Vec3 wi = way.normalized();
        return ImportanceSample{Vec2(3, 7), We, wi, way.norm(), wi.y(), 1 / (side * side), lensPoint(lens)};
    }
    CameraPdf pdf(const Ray&) const override { return {}; }

    static constexpr Real We = 3.7;
    static constexpr Real side = 0.6;
    mutable std::vector<Vec2> asked;

private:
    static Vec3 lensPoint(const Vec2& lens) { return {side * (lens.x() - 0.5), 2, side * (lens.y() - 0.5)}; }
};

// The mean over lens points: each is weighed by its density, looked at along its own direction, and shaded by what
// hides it. Each vertex has numbers of its own for it.
TEST(CameraConnection, SeesThroughALens) {
    const auto lens = std::make_shared<LensCamera>();
    // Hides the half of the lens with x < 0 from the origin.
    const SceneObject lid = {std::make_shared<Rectangle>(Vec3(-3, 1, -3), Vec3(3, 0, 0), Vec3(0, 0, 6)),
                             test::diffuse(test::rho),
                             {},
                             nullptr};
    const Scene scene = seenBy({test::floorAt(0, test::rho), lid}, lens);
    const Interaction at = test::meet(scene, {0.5, 0.5, 0.2}, {0, 0, 0});
    std::set<Real> different;
    RayCounts counts;
    for (int i = 0; i < 300; ++i) {
        const auto seen =
            connectToCamera(scene, at, Color(1, 2, 3), i % 3, test::independent.start(1, {0, 0}, i), counts);
        const Vec2 u = lens->asked.back();
        different.insert(u.x());
        ASSERT_EQ(seen.has_value(), u.x() > 0.5) << "To which point of the lens does the shadow ray go?";
        if (!seen) continue;
        const Vec3 way(LensCamera::side * (u.x() - 0.5), 2, LensCamera::side * (u.y() - 0.5));
        const Real cosine = 2 / way.norm();
        const Real density = 1 / (LensCamera::side * LensCamera::side);
        test::expectColor(
            seen->value,
            Color(1, 2, 3) * test::rho / pi * (LensCamera::We * cosine * cosine / way.squaredNorm() / density),
            "Is it divided by the density of the lens point?");
    }
    EXPECT_EQ(different.size(), 300U) << "Does every path have a lens point of its own?";
    lens->asked.clear();
    for (int vertex = 0; vertex < 4; ++vertex) connectToCamera(scene, at, Color::Ones(), vertex, numbers, counts);
    std::set<Real> vertices;
    for (const Vec2& u : lens->asked) vertices.insert(u.x());
    EXPECT_EQ(vertices.size(), 4U) << "Does every vertex have a lens point of its own?";
}

}  // namespace
}  // namespace caustic
