#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "curve/bezier_curve.h"
#include "curve_errors.h"
#include "math/bounds.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

using test::distance;
using test::NamedCurve;
using test::sizeOf;

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

std::vector<Real> someParameters(Random& random, int count) {
    std::vector<Real> parameters = {0, 1};
    for (int i = 0; i < count; ++i) parameters.push_back(random.uniform());
    return parameters;
}

// The bounds that bezier_curve.h states, for curves of all kinds.
TEST(BezierCurveProperty, PositionAndDerivativeStayWithinTheStatedRounding) {
    Random random(1, {1});
    for (const auto& [name, curve] : test::randomCurves(1, 300)) {
        const test::ReferenceCurve reference(curve);
        const int n = curve.degree();
        for (const Real t : someParameters(random, 8)) {
            EXPECT_LE(distance(curve.position(t), reference.position(t)), 3 * n * unitRoundoff * sizeOf(curve))
                << name << ", t = " << t;
            EXPECT_LE(distance(curve.derivative(t), reference.velocity(t)), 6 * n * n * unitRoundoff * sizeOf(curve))
                << name << ", t = " << t;
        }
    }
}

TEST(BezierCurveProperty, BeginsAndEndsAtControlPointsExactly) {
    for (const auto& [name, curve] : test::randomCurves(2, 120)) {
        EXPECT_EQ(curve.position(0), curve.controlPoints().front()) << name;
        EXPECT_EQ(curve.position(1), curve.controlPoints().back()) << name;
    }
}

// In the box of the control points, seen from any direction: that is what the convex hull is.
TEST(BezierCurveProperty, StaysInTheConvexHullOfItsControlPoints) {
    Random random(1, {3});
    for (const auto& [name, curve] : test::randomCurves(3, 120)) {
        const Vec3 direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        Real low = std::numeric_limits<Real>::infinity();
        Real high = -low;
        for (const Vec3& point : curve.controlPoints()) {
            low = std::min(low, direction.dot(point));
            high = std::max(high, direction.dot(point));
        }
        const Real rounding = 12 * (curve.degree() + 1) * unitRoundoff * sizeOf(curve);
        for (const Real t : someParameters(random, 20)) {
            const Real height = direction.dot(curve.position(t));
            EXPECT_GE(height, low - rounding) << name << ", t = " << t;
            EXPECT_LE(height, high + rounding) << name << ", t = " << t;
        }
    }
}

// Affine maps commute with evaluation, because the weights sum to 1.
TEST(BezierCurveProperty, IsAffinelyInvariant) {
    Random random(1, {4});
    for (const auto& [name, curve] : test::randomCurves(4, 120)) {
        Eigen::Matrix<Real, 3, 3> linear;
        for (Real& entry : linear.reshaped()) entry = random.uniform(-1, 1);
        const Vec3 offset(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        std::vector<Vec3> mapped;
        for (const Vec3& point : curve.controlPoints()) mapped.push_back(linear * point + offset);
        for (const Real t : someParameters(random, 5)) {
            const Vec3 difference = BezierCurve(mapped).position(t) - (linear * curve.position(t) + offset);
            EXPECT_LT(difference.norm(), 100 * (curve.degree() + 1) * unitRoundoff) << name << ", t = " << t;
        }
    }
}

// Degree elevation: Q_i = i/(n+1) P_{i-1} + (1 - i/(n+1)) P_i is the same curve (Farin 2002, eq. 6.1).
TEST(BezierCurveProperty, ElevatingTheDegreeChangesNothing) {
    Random random(1, {5});
    for (const auto& [name, curve] : test::randomCurves(5, 120)) {
        const std::vector<Vec3>& points = curve.controlPoints();
        std::vector<Vec3> elevated = {points.front()};
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Real share = static_cast<Real>(i) / static_cast<Real>(points.size());
            elevated.push_back(share * points[i - 1] + (1 - share) * points[i]);
        }
        elevated.push_back(points.back());
        for (const Real t : someParameters(random, 5)) {
            const Vec3 difference = BezierCurve(elevated).position(t) - curve.position(t);
            EXPECT_LT(difference.norm(), 20 * (curve.degree() + 1) * unitRoundoff * sizeOf(curve))
                << name << ", t = " << t;
        }
    }
}

TEST(BezierCurveProperty, ReversedControlPointsRunTheSameCurveBackwards) {
    Random random(1, {6});
    for (const auto& [name, curve] : test::randomCurves(6, 120)) {
        std::vector<Vec3> points = curve.controlPoints();
        std::reverse(points.begin(), points.end());
        const BezierCurve reversed(points);
        for (Real t : someParameters(random, 5)) {
            t = static_cast<Real>(static_cast<float>(t));  // so that 1 - t is exact
            const Vec3 difference = reversed.position(1 - t) - curve.position(t);
            EXPECT_LT(difference.norm(), 12 * curve.degree() * unitRoundoff * sizeOf(curve) + 1e-300) << name;
        }
    }
}

// Both parts against the 113-bit curve; they meet in the same point to the last bit.
TEST(BezierCurveProperty, SplitPartsTraceTheCurve) {
    Random random(1, {7});
    for (const auto& [name, curve] : test::randomCurves(7, 120)) {
        const test::ReferenceCurve reference(curve);
        const Real t = random.uniform();
        const auto [left, right] = curve.split(t);
        EXPECT_EQ(left.controlPoints().back(), right.controlPoints().front()) << name;
        const Real rounding = 6 * (curve.degree() + 1) * unitRoundoff * sizeOf(curve);
        for (const Real s : someParameters(random, 5)) {
            EXPECT_LE(distance(left.position(s), reference.position(test::Quad(t) * s)), rounding) << name;
            EXPECT_LE(distance(right.position(s), reference.position(t + (1 - test::Quad(t)) * s)), rounding) << name;
        }
    }
}

TEST(BezierCurveProperty, ConstructionRunsFromTheControlPointsToThePoint) {
    for (const auto& [name, curve] : test::randomCurves(9, 60)) {
        const Real t = 0.375;
        const std::vector<std::vector<Vec3>> levels = curve.construction(t);
        ASSERT_EQ(levels.size(), curve.controlPoints().size()) << name;
        EXPECT_EQ(levels.front(), curve.controlPoints()) << name;
        EXPECT_EQ(levels.back().front(), curve.position(t)) << name;
        for (std::size_t r = 1; r < levels.size(); ++r) {
            ASSERT_EQ(levels[r].size(), levels.size() - r) << name;
            for (std::size_t i = 0; i < levels[r].size(); ++i) {
                const Vec3 between = (1 - t) * levels[r - 1][i] + t * levels[r - 1][i + 1];
                EXPECT_LT((levels[r][i] - between).norm(), 12 * curve.degree() * unitRoundoff * sizeOf(curve)) << name;
            }
        }
    }
}

// Where the curve moves at a speed that rounding can't blur, the tangent is the derivative's direction.
TEST(BezierCurveProperty, TangentIsTheDirectionOfTheDerivative) {
    Random random(1, {10});
    int compared = 0;
    for (const auto& [name, curve] : test::randomCurves(10, 300)) {
        for (const Real t : someParameters(random, 5)) {
            const std::optional<Vec3> tangent = curve.tangent(t);
            if (tangent) {
                EXPECT_NEAR(tangent->norm(), 1, 4 * unitRoundoff) << name;
            }
            const Vec3 velocity = curve.derivative(t);
            if (velocity.norm() < 1e-3) continue;
            ASSERT_TRUE(tangent) << name << ", t = " << t;
            EXPECT_LT((*tangent - velocity.normalized()).norm(), 1e-10) << name << ", t = " << t;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1500);
}

TEST(BezierCurveProperty, HodographIsTheDerivativeAsACurve) {
    Random random(1, {11});
    for (const auto& [name, curve] : test::randomCurves(11, 120)) {
        const BezierCurve hodograph = curve.hodograph();
        EXPECT_EQ(hodograph.degree(), std::max(0, curve.degree() - 1)) << name;
        for (const Real t : someParameters(random, 5)) {
            const Real rounding = 20 * (curve.degree() + 1) * (curve.degree() + 1) * unitRoundoff * sizeOf(curve);
            EXPECT_LT((hodograph.position(t) - curve.derivative(t)).norm(), rounding) << name;
        }
    }
    EXPECT_EQ(BezierCurve({Vec3(1, 2, 3)}).hodograph().controlPoints().front(), Vec3::Zero());
}

}  // namespace
}  // namespace caustic
