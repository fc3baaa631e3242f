#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "curve/bezier_curve.h"
#include "curve_errors.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

using test::distance;
using test::sizeOf;

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

BezierCurve scaled(const BezierCurve& curve, Real factor) {
    std::vector<Vec3> points = curve.controlPoints();
    for (Vec3& point : points) point *= factor;
    return BezierCurve(points);
}

TEST(BezierCurveStability, WithinAHundredUlpForEveryDegreeUpTo60) {
    Random random(1, {1});
    for (int degree = 0; degree <= 60; ++degree) {
        const BezierCurve curve = test::randomCurve(random, degree);
        const Real size = sizeOf(curve);
        const Real ulp = std::nextafter(size, 2 * size) - size;
        const test::ReferenceCurve reference(curve);
        for (int i = 0; i < 50; ++i) {
            const Real t = random.uniform();
            EXPECT_LE(distance(curve.position(t), reference.position(t)), 100 * ulp)
                << "degree " << degree << ", t = " << t;
        }
    }
}

// Outside [0, 1] a round can enlarge errors by |1-t| + |t|, as it can the coordinates.
TEST(BezierCurveStability, OutsideTheIntervalErrorsGrowAsTheWeightsDo) {
    Random random(1, {2});
    for (int degree = 1; degree <= 20; ++degree) {
        const BezierCurve curve = test::randomCurve(random, degree);
        const test::ReferenceCurve reference(curve);
        for (const Real t : {-2.0, -0.3, -1e-12, 1 + 1e-12, 1.4, 3.0}) {
            const Real growth = std::pow(std::abs(1 - t) + std::abs(t), degree);
            const Real rounding = 4 * degree * unitRoundoff * growth * sizeOf(curve);
            EXPECT_LE(distance(curve.position(t), reference.position(t)), rounding)
                << "degree " << degree << ", t = " << t;
            EXPECT_LE(distance(curve.derivative(t), reference.velocity(t)), 2 * degree * rounding)
                << "degree " << degree << ", t = " << t;
            const auto [left, right] = curve.split(t);
            EXPECT_EQ(left.controlPoints().back(), right.controlPoints().front());
            EXPECT_LE(distance(left.position(0.5), reference.position(test::Quad(t) / 2)), 4 * rounding)
                << "degree " << degree << ", t = " << t;
        }
    }
}

TEST(BezierCurveStability, HugeAndTinyCoordinatesScaleExactly) {
    for (const auto& [name, curve] : test::randomCurves(3, 60)) {
        for (const int exponent : {-500, 500}) {  // 2^±500 is about 1e±150; a power of two changes no digit
            const BezierCurve far = scaled(curve, std::ldexp(1.0, exponent));
            for (const Real t : {0.0, 0.3, 0.9}) {
                EXPECT_EQ(far.position(t), std::ldexp(1.0, exponent) * curve.position(t)) << name;
                EXPECT_EQ(far.derivative(t), std::ldexp(1.0, exponent) * curve.derivative(t)) << name;
                const std::optional<Vec3> tangent = curve.tangent(t);
                const std::optional<Vec3> farTangent = far.tangent(t);
                ASSERT_EQ(tangent.has_value(), farTangent.has_value()) << name;
                if (tangent) {
                    EXPECT_LT((*tangent - *farTangent).norm(), 1e-14) << name;
                }
            }
        }
    }
}

// With coincident control points at an end the derivative is zero there; the tangent points to the first other one.
TEST(BezierCurveStability, TangentAtCoincidentControlPointsIsTheLimit) {
    Random random(1, {4});
    for (int degree = 1; degree <= 12; ++degree) {
        for (int equal = 1; equal <= degree; ++equal) {
            std::vector<Vec3> points = test::randomCurve(random, degree).controlPoints();
            const auto first = static_cast<std::size_t>(equal);
            for (std::size_t i = 1; i < first; ++i) points[i] = points[0];
            const BezierCurve curve(points);
            const std::optional<Vec3> start = curve.tangent(0);
            ASSERT_TRUE(start);
            EXPECT_LT((*start - (points[first] - points[0]).normalized()).norm(), 1e-14) << degree << ", " << equal;

            const BezierCurve reversed(std::vector<Vec3>(points.rbegin(), points.rend()));
            const std::optional<Vec3> end = reversed.tangent(1);
            ASSERT_TRUE(end);
            EXPECT_LT((*end - (points[0] - points[first]).normalized()).norm(), 1e-14) << degree << ", " << equal;
        }
    }
}

// B = (s², s³), s = t - c, turns round at its cusp: it arrives along -x and leaves along +x. The parameter of the cusp
// is a rounded number, so "leaves" is what the tangent says a little later at the latest.
TEST(BezierCurveStability, TangentAtACuspIsUnitAndFinite) {
    Random random(1, {5});
    for (int i = 0; i < 1000; ++i) {
        const BezierCurve curve = test::randomCusp(random, 2 + i % 11);
        Real slowest = 1;
        for (int k = 0; k <= 1000; ++k) {
            if (curve.derivative(k / 1000.0).norm() < curve.derivative(slowest).norm()) slowest = k / 1000.0;
        }
        for (const Real t : {slowest - 1e-3, slowest, slowest + 1e-3}) {
            const std::optional<Vec3> tangent = curve.tangent(t);
            ASSERT_TRUE(tangent) << "cusp " << i;
            EXPECT_NEAR(tangent->norm(), 1, 1e-15) << "cusp " << i;
        }
    }
}

TEST(BezierCurveStability, TangentAtARepresentableCuspIsTheDirectionInWhichTheCurveLeaves) {
    // x = (2t-1)², y = (2t-1)³: control points by the polar form.
    const BezierCurve curve({Vec3(1, -1, 0), Vec3(-1.0 / 3, 1, 0), Vec3(-1.0 / 3, -1, 0), Vec3(1, 1, 0)});
    const std::optional<Vec3> tangent = curve.tangent(0.5);
    ASSERT_TRUE(tangent);
    EXPECT_LT((*tangent - Vec3(1, 0, 0)).norm(), 1e-14);
}

TEST(BezierCurveStability, ASinglePointHasNoTangent) {
    for (int degree = 0; degree <= 60; ++degree) {
        const BezierCurve point(std::vector<Vec3>(static_cast<std::size_t>(degree) + 1, Vec3(1e5, -0.1, 3)));
        for (const Real t : {0.0, 0.123, 1.0}) EXPECT_FALSE(point.tangent(t)) << "degree " << degree << ", t = " << t;
    }
}

TEST(BezierCurveStability, RefusesWhatIsNoCurve) {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    EXPECT_THROW(BezierCurve({}), InputError);
    EXPECT_THROW(BezierCurve({Vec3(0, 0, 0), Vec3(0, infinity, 0)}), InputError);
    EXPECT_THROW(BezierCurve({Vec3(0, 0, std::numeric_limits<Real>::quiet_NaN())}), InputError);
}

}  // namespace
}  // namespace caustic
