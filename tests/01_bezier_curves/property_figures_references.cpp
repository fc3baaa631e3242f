#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "curve_with_turns.h"
#include "length_methods.h"
#include "measures/reference_length.h"

namespace caustic {
namespace {

// A line's speed is constant, so its length is the distance of its ends, whatever the degree.
TEST(ReferenceLength, OfARaisedLineIsTheDistance) {
    const std::vector<Vec3> line = {Vec3(0, 0, 0), Vec3(1, 2, 2), Vec3(2, 4, 4), Vec3(3, 6, 6)};
    EXPECT_LT(static_cast<double>(abs(referenceLength(line) - 9)), 1e-24);
}

// x = t² / 2 with y = t: the parabola's length is (√2 + ln(1 + √2)) / 2.
TEST(ReferenceLength, OfAParabolaIsItsClosedForm) {
    const std::vector<Vec3> parabola = {Vec3(0, 0, 0), Vec3(0, 0.5, 0), Vec3(0.5, 1, 0)};
    const Real113 root = sqrt(Real113(2));
    EXPECT_LT(static_cast<double>(abs(referenceLength(parabola) - (root + log(1 + root)) / 2)), 1e-24);
}

// Two independent ways: the closed form of the semicubical parabola's length, and quadrature of its speed.
TEST(ReferenceLength, OfACuspIsItsClosedForm) {
    for (const Real cusp : {0.125, 0.375, 0.5, 0.75}) {
        const BezierCurve curve = cuspidalCubic(cusp, 3, 0);
        const Real113 reference = referenceLength(curve.controlPoints(), {Real113(cusp)});
        EXPECT_NEAR(static_cast<Real>(reference), cuspidalCubicLength(cusp, 3), 1e-15) << "cusp at " << cusp;
    }
}

TEST(ExampleCurves, CuspidalCubicStopsAndTurnsBackAtItsCusp) {
    Random random(1, {1});
    for (int trial = 0; trial < 200; ++trial) {
        const Real cusp = random.uniform(0.05, 0.95);
        const BezierCurve curve = cuspidalCubic(cusp, 3, random.uniform(0, 6));
        EXPECT_LT(curve.derivative(cusp).norm(), 1e-14);
        const Vec3 before = curve.derivative(cusp - 1e-6).normalized();
        const Vec3 after = curve.derivative(cusp + 1e-6).normalized();
        EXPECT_LT(before.dot(after), -0.999) << "It must come back the way that it went.";
    }
}

// n points make the rule exact to degree 2 n - 1 (Davis and Rabinowitz 1984, sec. 2.7): the speed of a raised line is
// constant, and one point is enough.
TEST(ExampleCurves, PlainGaussLengthOfALineIsExactWithOnePoint) {
    const BezierCurve line({Vec3(0, 0, 0), Vec3(1, 2, 2), Vec3(2, 4, 4)});
    EXPECT_NEAR(plainGaussLength(line, gaussLegendreRule(1)), 6, 1e-14);
}

// Between its turns x rises and falls in turn; at them its derivative is zero; y climbs evenly.
TEST(ExampleCurves, CurveWithTurnsTurnsThereAndNowhereElse) {
    const std::vector<Real> turns = {0.2, 0.35, 0.6, 0.85};
    const BezierCurve curve = curveWithTurns(turns);
    for (const Real turn : turns) EXPECT_NEAR(curve.derivative(turn).x(), 0, 1e-13) << "at " << turn;
    int changes = 0;
    for (int i = 1; i <= 1000; ++i) {
        const bool rising = curve.derivative(i / 1000.0).x() > 0;
        if (rising != (curve.derivative((i - 1) / 1000.0).x() > 0)) ++changes;
        EXPECT_NEAR(curve.position(i / 1000.0).y(), i / 1000.0, 1e-14);
    }
    EXPECT_EQ(changes, 4);
    EXPECT_LT(curve.derivative(1).x(), 0) << "The last turn is a maximum.";
}

}  // namespace
}  // namespace caustic
