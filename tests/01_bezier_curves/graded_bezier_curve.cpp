#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "curve/bezier_curve.h"

namespace caustic {
namespace {

// Sum of C(n,i) (1-t)^(n-i) t^i P_i, the definition. The degrees here are at most 6: all of it is exact to 1e-15.
Vec3 bernsteinForm(const std::vector<Vec3>& points, Real t) {
    const auto n = static_cast<int>(points.size()) - 1;
    Vec3 sum = Vec3::Zero();
    int binomial = 1;
    for (int i = 0; i <= n; ++i) {
        sum += binomial * std::pow(1 - t, n - i) * std::pow(t, i) * points[static_cast<std::size_t>(i)];
        binomial = binomial * (n - i) / (i + 1);
    }
    return sum;
}

std::vector<Vec3> somePoints(int count) {
    const std::vector<Vec3> points = {{0, 0, 1}, {1, 2, 0}, {3, 3, -1}, {4, 0, 2}, {2, -1, 3}, {1, 1, 1}, {-2, 0, 4}};
    return {points.begin(), points.begin() + count};
}

// Coordinates are at most 4 and degrees at most 6, so rounding stays far below.
constexpr Real tolerance = 1e-13;

// The definition of a Bézier curve (Farin 2002, eq. 5.7).
TEST(BezierCurve, PositionMatchesBernsteinForm) {
    for (int degree = 0; degree <= 6; ++degree) {
        const std::vector<Vec3> points = somePoints(degree + 1);
        for (const Real t : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
            const Vec3 error = BezierCurve(points).position(t) - bernsteinForm(points, t);
            EXPECT_LT(error.norm(), tolerance)
                << "degree " << degree << ", t = " << t
                << ": which end does the weight t belong to, and how many rounds are there for n + 1 points?";
        }
    }
}

// This curve is y = x² with x = 2t - 1, whatever t.
TEST(BezierCurve, PositionGoesOnOutsideTheInterval) {
    const BezierCurve curve({Vec3(-1, 1, 0), Vec3(0, -1, 0), Vec3(1, 1, 0)});
    for (const Real t : {-1.0, -0.25, 1.5, 3.0}) {
        const Vec3 point = curve.position(t);
        EXPECT_NEAR(std::abs(point.x()), std::abs(2 * t - 1), tolerance) << "Is t = " << t << " forced into [0, 1]?";
        EXPECT_NEAR(point.y(), point.x() * point.x(), tolerance);
    }
}

// The weights sum to 1 for every degree (partition of unity).
TEST(BezierCurve, CoincidentControlPointsOfDegree60GiveThatPoint) {
    const Vec3 point(3, -2, 0.5);
    const BezierCurve curve(std::vector<Vec3>(61, point));
    for (const Real t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        EXPECT_LT((curve.position(t) - point).norm(), tolerance)
            << "t = " << t << ": do the weights sum to 1? Binomials of 60 don't fit into an int.";
    }
}

// B'(t) is the curve of degree n - 1 over n (P_{i+1} - P_i) (Farin 2002, eq. 5.18).
TEST(BezierCurve, DerivativeMatchesTheHodograph) {
    for (int degree = 1; degree <= 6; ++degree) {
        const std::vector<Vec3> points = somePoints(degree + 1);
        std::vector<Vec3> differences;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) differences.push_back(degree * (points[i + 1] - points[i]));
        for (const Real t : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
            const Vec3 error = BezierCurve(points).derivative(t) - bernsteinForm(differences, t);
            EXPECT_LT(error.norm(), tolerance)
                << "degree " << degree << ", t = " << t
                << ": which pair is the last one, and what is it multiplied by? Degree n has n + 1 points.";
        }
    }
}

// A curve of degree 0 stays where it is.
TEST(BezierCurve, DerivativeOfASinglePointIsZero) {
    EXPECT_EQ(BezierCurve({Vec3(3, 1, 2)}).derivative(0.5), Vec3::Zero()) << "How many pairs has a single point?";
}

// The parts are the same curve with another parameter: t s on the left, t + (1-t) s on the right.
TEST(BezierCurve, SplitPartsTraceTheCurve) {
    const std::vector<Vec3> points = somePoints(6);
    for (const Real t : {0.0, 0.25, 0.5, 0.7, 1.0}) {
        const auto [left, right] = BezierCurve(points).split(t);
        ASSERT_EQ(left.degree(), 5);
        ASSERT_EQ(right.degree(), 5);
        for (const Real s : {0.0, 0.3, 0.5, 1.0}) {
            const Vec3 onLeft = bernsteinForm(left.controlPoints(), s);
            const Vec3 onRight = bernsteinForm(right.controlPoints(), s);
            EXPECT_LT((onLeft - bernsteinForm(points, t * s)).norm(), tolerance)
                << "left part of t = " << t << " at " << s << ": which side of the triangle is it?";
            EXPECT_LT((onRight - bernsteinForm(points, t + (1 - t) * s)).norm(), tolerance)
                << "right part of t = " << t << " at " << s << ": in which order do its control points come?";
        }
    }
}

// Beyond the ends split() extends the curve: the same identities hold. y = x² on both parts.
TEST(BezierCurve, SplitExtendsTheCurveOutsideTheInterval) {
    const BezierCurve curve({Vec3(-1, 1, 0), Vec3(0, -1, 0), Vec3(1, 1, 0)});
    const auto [left, right] = curve.split(2);
    EXPECT_LT((left.controlPoints().back() - Vec3(3, 9, 0)).norm(), tolerance) << "Is t = 2 forced into [0, 1]?";
    EXPECT_LT((left.controlPoints()[1] - Vec3(1, -3, 0)).norm(), tolerance);
    EXPECT_LT((right.controlPoints().front() - Vec3(3, 9, 0)).norm(), tolerance);
    EXPECT_LT((right.controlPoints()[1] - Vec3(2, 3, 0)).norm(), tolerance);
}

}  // namespace
}  // namespace caustic
