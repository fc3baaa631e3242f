#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "integrator/vertex_connection.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "vertex_scenes.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const Color above(0.4, 0.9, 0.2);  // of the ceiling

SceneObject ceiling(const Color& reflectance) {
    return {std::make_shared<Plane>(Vec3(0, 3, 0), -Vec3::UnitY()), test::diffuse(reflectance), {}, nullptr};
}

Scene of(const std::vector<SceneObject>& objects) { return Scene({objects, {}, Color::Zero(), nullptr}); }

Color connected(const Scene& scene, const Interaction& eye, const Interaction& light) {
    const Color one = Color::Ones();
    RayCounts counts;
    const auto joined = connectVertices(scene, {eye, one}, {light, one}, counts);
    EXPECT_TRUE(joined) << "Is light lost that gets from one to the other?";
    return joined ? joined->value : Color::Zero();
}

void expectNothing(const Scene& scene, const Interaction& eye, const Interaction& light, const char* question) {
    const Color one = Color::Ones();
    RayCounts counts;
    EXPECT_FALSE(connectVertices(scene, {eye, one}, {light, one}, counts)) << question;
}

// β f cos θ cos θ' / d² f' β' between two planes that stand askew, at any size.
TEST(VertexConnection, HasTheGeometryTerm) {
    const Vec3 up = Vec3(0.36, -0.48, 0.8);
    const Vec3 down = Vec3(-0.6, 0, -0.8);
    const Color betaEye(1, 2, 3);
    const Color betaLight(5, 7, 11);
    for (const Real size : test::sizes) {
        const Vec3 foot = size * Vec3(5, -3, 2);
        const Vec3 head = size * Vec3(6, -4, 6);
        const Scene scene = of({{std::make_shared<Plane>(foot, up), test::diffuse(test::rho), {}, nullptr},
                                {std::make_shared<Plane>(head, down), test::diffuse(above), {}, nullptr}});
        for (const Vec3& aside : {Vec3(0, 0, 0), Vec3(0.3, 0.1, 0.4), Vec3(0.1, 2, 1)}) {
            const Interaction eye = test::meet(scene, foot + size * (up + 0.2 * aside), foot);
            const Interaction light = test::meet(scene, head + size * (down + aside), head);
            RayCounts counts;
            const auto joined = connectVertices(scene, {eye, betaEye}, {light, betaLight}, counts);
            ASSERT_TRUE(joined) << "Where does the shadow ray start, and where does it end?";
            const Vec3 way = (head - foot) / size;
            const Real geometry = way.dot(up) * -way.dot(down) / std::pow(way.squaredNorm(), 2);
            test::expectColor(joined->value * (size * size),
                              betaEye * betaLight * test::rho / pi * above / pi * geometry,
                              "Two cosines over the distance squared?");
            EXPECT_LE((joined->wi - way.normalized()).norm(), 1e-9) << "From the eye's vertex to the light's?";
            EXPECT_NEAR(joined->squaredDistance / (size * size), way.squaredNorm(), 1e-8);
        }
    }
}

// On a smooth mesh the end of the eye's walk scatters radiance, f |wi·ns|; that of the light's walk importance,
// f |wo·ns| |wi·ng| / |wo·ng| (Veach 5.3.2).
TEST(VertexConnection, ScattersWhatEachWalkCarries) {
    const Vec3 ns = Vec3(0.3, 1, 0.1).normalized();
    const SceneObject floor = {
        test::leaningPlane(Vec3::Zero(), Vec3::UnitY(), ns, 9), test::diffuse(test::rho), {}, nullptr};
    const Scene scene = of({floor, ceiling(above)});
    const Vec3 low(0.2, 0, 0);
    const Vec3 high(1, 3, 0.5);
    const Vec3 from(-1, 1.5, 0.4);
    const Interaction onFloor = test::meet(scene, from, low);
    const Interaction onCeiling = test::meet(scene, {0, 1, 0}, high);
    const Vec3 up = (high - low).normalized();
    const Vec3 wo = (from - low).normalized();
    const Color common = test::rho / pi * above / pi * up.y() / (high - low).squaredNorm();
    test::expectColor(connected(scene, onFloor, onCeiling), common * up.dot(ns), "What does the eye's walk carry?");
    test::expectColor(connected(scene, onCeiling, onFloor), common * wo.dot(ns) * up.y() / wo.y(),
                      "What does the light's walk carry?");
}

// In a medium the phase function takes the place of f, asked for the direction that the walk came from, and there is no
// cosine. At one end or at both.
TEST(VertexConnection, EndsInMediaToo) {
    const test::ForwardPhase phase;
    const Scene scene = of({ceiling(above)});
    const Vec3 low(0.2, 0.5, 0);
    const Vec3 middle(0.5, 2, 1);
    const Vec3 high(1, 3, 0.5);
    const Vec3 wo[2] = {Vec3(0.6, 0, 0.8), Vec3(0.48, 0.6, 0.64)};
    const Interaction one(low, wo[0], phase, {});
    const Interaction other(middle, wo[1], phase, {});
    const Interaction onCeiling = test::meet(scene, {0, 1, 0}, high);
    const auto p = [](const Vec3& to, const Vec3& wi) { return (1 - to.dot(wi.normalized()) / 2) / (4 * pi); };
    test::expectColor(connected(scene, one, other),
                      Color::Constant(p(wo[0], middle - low) * p(wo[1], low - middle) / (middle - low).squaredNorm()),
                      "Which way does each end scatter to?");
    const Color expected =
        above / pi * (p(wo[0], high - low) * (high - low).normalized().y() / (high - low).squaredNorm());
    test::expectColor(connected(scene, one, onCeiling), expected, "Has the end in the medium a cosine?");
    test::expectColor(connected(scene, onCeiling, one), expected, "Has the end in the medium a cosine?");
    expectNothing(scene, one, Interaction(low, wo[1], phase, {}), "Which direction leads from a point to itself?");
}

// A wall between both ends; an end that is black, or turned away. One colour may end where others go on.
TEST(VertexConnection, AsksWhatIsInTheWay) {
    const auto eyeEnd = [](const Scene& scene) { return test::meet(scene, {0.1, 0.5, 0}, {0, 0, 0}); };
    const auto lightEnd = [](const Scene& scene) { return test::meet(scene, {0.1, 2, 0}, {0, 3, 0}); };
    const Scene open = of({test::floorAt(0, test::rho), ceiling(above)});
    const Color clear = connected(open, eyeEnd(open), lightEnd(open));
    const SceneObject wall = {std::make_shared<Rectangle>(Vec3(-9, 1, -9), Vec3(18, 0, 0), Vec3(0, 0, 18)),
                              test::diffuse(test::rho),
                              {},
                              nullptr};
    const Scene dark = of({test::floorAt(0, test::rho), ceiling(above), wall});
    expectNothing(dark, eyeEnd(dark), lightEnd(dark), "Is there a wall between?");
    for (const auto& [low, high] :
         {std::pair(Color(0.8, 0, 0.3), Color(0.4, 0.9, 0)), std::pair(Color(0, 0.5, 0.3), Color(0.4, 0.9, 0)),
          std::pair(Color(0.8, 0.5, 0), Color(0, 0.9, 0.2))}) {
        const Scene scene = of({test::floorAt(0, low), ceiling(high)});
        test::expectColor(connected(scene, eyeEnd(scene), lightEnd(scene)), clear * low / test::rho * high / above,
                          "Does light end when one of its colours does?");
    }
    const Scene blackFloor = of({test::floorAt(0, Color::Zero()), ceiling(above)});
    expectNothing(blackFloor, eyeEnd(blackFloor), lightEnd(blackFloor), "Does a black floor scatter anything?");
    expectNothing(blackFloor, lightEnd(blackFloor), eyeEnd(blackFloor), "Does a black floor scatter anything?");
    expectNothing(open, test::meet(open, {0.1, -1, 0}, {0, 0, 0}), lightEnd(open), "Does light go through the floor?");
    const Scene behind = of({test::floorAt(0, test::rho), ceiling(above), test::floorAt(3.001, test::rho)});
    test::expectColor(connected(behind, eyeEnd(behind), lightEnd(behind)), clear,
                      "Where does the shadow ray end: at the other vertex, or behind it?");

    for (const Real size : test::sizes) {
        const auto ball = [&](const Vec3& center) {
            return SceneObject{std::make_shared<Sphere>(size * center, size), test::diffuse(test::rho), {}, nullptr};
        };
        const Scene balls = of({ball({0, 0, 0}), ball({1, 5, 2})});
        for (int i = 0; i < 200; ++i) {
            const Vec3 aside(0.5 * std::cos(i), 0, 0.5 * std::sin(2.0 * i));
            const Interaction eye = test::meet(balls, size * (Vec3(0, 2, 0) + aside), size * 0.3 * aside);
            const Interaction light = test::meet(balls, size * (Vec3(1, 2.5, 2) + aside), size * Vec3(1, 5, 2));
            EXPECT_GT(connected(balls, eye, light).minCoeff(), 0) << "Does a ball shade itself?";
        }
    }
}

// Tinted air lets e^(−σ d) pass, of each colour. Paper around tinted air lets light out and in: what is between starts
// on the side of the eye's vertex that faces the light's.
TEST(VertexConnection, IsAbsorbedOnItsWay) {
    const auto eyeEnd = [](const Scene& scene) { return test::meet(scene, {0.1, 0.2, 0}, {0, 0, 0}); };
    const auto lightEnd = [](const Scene& scene) { return test::meet(scene, {0.1, 2.8, 0}, {0, 3, 0}); };
    const Scene open = of({test::floorAt(0, test::rho), ceiling(above)});
    const Color clear = connected(open, eyeEnd(open), lightEnd(open));
    const Color thick(5000, 0.1, 0.7);
    for (const auto& [low, high] :
         {std::pair(1.0, 1.5), std::pair(-5.0, 1.5), std::pair(-5.0, 9.0), std::pair(1.0, 9.0)}) {
        const Scene tinted =
            of({test::floorAt(0, test::rho), ceiling(above), test::tintedAir({-9, low, -9}, {9, high, 9}, thick)});
        Color expected = clear * (-thick * (std::min(3.0, high) - std::max(0.0, low))).exp();
        expected.x() = 0;
        test::expectColor(connected(tinted, eyeEnd(tinted), lightEnd(tinted)), expected, "What is in between?");
    }
    const Color through(0.2, 0.3, 0.4);
    const Scene scene = of({test::lantern(through, test::rho), ceiling(above)});
    const Interaction onCeiling = test::meet(scene, {0.1, 2.5, 0}, {0, 3, 0});
    const Interaction onBottom = test::meet(scene, {0, -0.5, 0}, {0, -1, 0});
    for (const bool inside : {false, true}) {
        const Interaction onTop = test::meet(scene, {0, inside ? 0.5 : 1.5, 0}, {0, 1, 0});
        const Color up = inside ? through : test::rho;
        const Color down = inside ? test::rho : through;
        const Color outside = up / pi * above / pi / 4;
        const Color within = down / pi * test::rho / pi / 4 * (-2 * test::sigma).exp();
        const char* question = "On which side of the eye's vertex does the way start, and what is it in there?";
        test::expectColor(connected(scene, onTop, onCeiling), outside, question);
        test::expectColor(connected(scene, onCeiling, onTop), outside, question);
        test::expectColor(connected(scene, onTop, onBottom), within, question);
        test::expectColor(connected(scene, onBottom, onTop), within, question);
    }
}

}  // namespace
}  // namespace caustic
