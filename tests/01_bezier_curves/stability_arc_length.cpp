#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "curve/arc_length.h"
#include "curve/gauss_legendre.h"
#include "support/known_curves.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

BezierCurve scaled(const BezierCurve& curve, Real factor) {
    std::vector<Vec3> points = curve.controlPoints();
    for (Vec3& point : points) point *= factor;
    return BezierCurve(points);
}

// A line that is walked forth, and back near its end: x' = (c - t)(1 + ...) changes sign at c, close to 1.
struct FoldedLine {
    BezierCurve curve;
    Real length;
};

FoldedLine foldedLine(Real c) {
    // x = c t - t²/2: up to c²/2, then down to c - 1/2.
    const Real end = c - Real(0.5);
    return {BezierCurve({Vec3(0, 0, 0), Vec3(c / 2, 0, 0), Vec3(end, 0, 0)}), c * c - end};
}

Real plainRule(const GaussRule& rule, const BezierCurve& curve, Real from, Real to) {
    Real sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const Real t = (from + to) / 2 + rule.nodes[i] * (to - from) / 2;
        sum += rule.weights[i] * curve.derivative(t).norm();
    }
    return sum * (to - from) / 2;
}

// Fragile: halve until the halves agree with the whole. When the fold lies beyond the last node, all of them integrate
// the same polynomial exactly, agree to the last bit, and are wrong.
TEST(ArcLengthStability, HalvesThatAgreeCanBothBeWrongButTheBoundIsNot) {
    const GaussRule rule = gaussLegendreRule(16);
    Random random(1, {1});
    int fooled = 0;
    constexpr int trials = 1000;
    for (int i = 0; i < trials; ++i) {
        const auto [curve, length] = foldedLine(1 - std::pow(10, random.uniform(-5, -2)));
        const Real whole = plainRule(rule, curve, 0, 1);
        const Real halves = plainRule(rule, curve, 0, 0.5) + plainRule(rule, curve, 0.5, 1);
        const bool agree = std::abs(whole - halves) <= 1e-12;
        if (agree && std::abs(halves - length) > 1e-11) ++fooled;

        const LengthEstimate estimate = gaussLength(curve, 1e-12);
        EXPECT_LE(std::abs(estimate.length - length), estimate.error) << "fold " << i;
        EXPECT_LE(estimate.error, 2e-12) << "fold " << i;
    }
    EXPECT_GT(fooled, trials / 10) << "the fragile way is expected to fail";
    RecordProperty("fooled", fooled);
}

// Cusps cost some bisections each, never an endless loop.
TEST(ArcLengthStability, CuspsNeedFewEvaluations) {
    Random random(1, {2});
    for (int i = 0; i < 300; ++i) {
        const LengthEstimate estimate = gaussLength(test::randomCusp(random, 2 + i % 11), 1e-12);
        EXPECT_LT(estimate.evaluations, 10'000) << "cusp " << i;
        EXPECT_LT(estimate.error, 1e-11) << "cusp " << i;
    }
}

TEST(ArcLengthStability, HugeAndTinyCoordinates) {
    for (const auto& [name, curve] : test::randomCurves(3, 60)) {
        const LengthEstimate estimate = gaussLength(curve, 1e-9);
        for (const Real factor : {1e150, 1e-150}) {
            const BezierCurve far = scaled(curve, factor);
            const LengthEstimate farEstimate = gaussLength(far, 1e-9 * factor);
            EXPECT_TRUE(std::isfinite(farEstimate.length)) << name;
            EXPECT_LE(farEstimate.error, 1e-9 * factor) << name;
            EXPECT_NEAR(farEstimate.length / factor, estimate.length, 2e-9) << name;
            EXPECT_NEAR(chordLength(far, 50) / factor, chordLength(curve, 50), 1e-12) << name;
            const std::vector<Real> cuts = evenlySpaced(curve, 3);
            const std::vector<Real> farCuts = evenlySpaced(far, 3);
            const Real first = gaussLength(curve, 1e-12, 0, cuts[1]).length;
            EXPECT_NEAR(gaussLength(curve, 1e-12, 0, farCuts[1]).length, first, 1e-9) << name;
        }
    }
}

TEST(ArcLengthStability, ZeroLengthIsZero) {
    for (const int degree : {0, 1, 5, 60}) {
        const Vec3 place(1e10, -0.1, 3);
        const BezierCurve point(std::vector<Vec3>(static_cast<std::size_t>(degree) + 1, place));
        const LengthEstimate estimate = gaussLength(point, 1e-12);
        EXPECT_EQ(estimate.length, 0);
        EXPECT_EQ(estimate.error, 0);
        // Both ends of each chord are within position()'s bound, 3 n u of the coordinate, of the point.
        const Real rounding = 10 * 2 * 3 * degree * 0x1p-53 * place.norm();
        EXPECT_LE(chordLength(point, 10), rounding);
        EXPECT_EQ(evenlySpaced(point, 2), (std::vector<Real>{0, 0.5, 1}));
    }
    EXPECT_EQ(gaussLength(test::parabola(), 1e-12, 0.3, 0.3).length, 0);
}

TEST(ArcLengthStability, Degree60) {
    Random random(1, {5});
    for (int i = 0; i < 3; ++i) {
        const BezierCurve curve = test::randomCurve(random, 60);
        const LengthEstimate estimate = gaussLength(curve, 1e-9);
        const test::Quad truth = test::ReferenceCurve(curve).length();
        EXPECT_LE(std::abs(static_cast<Real>(truth - estimate.length)), estimate.error);
        EXPECT_LE(estimate.error, 1e-9);
    }
}

// Far from the origin the differences of the control points are what counts.
TEST(ArcLengthStability, FarFromTheOriginTheLengthStays) {
    const LengthEstimate near = gaussLength(test::semicubicalParabola(0.25), 1e-10);
    std::vector<Vec3> points = test::semicubicalParabola(0.25).controlPoints();
    for (Vec3& point : points) point += Vec3(1e6, -1e6, 1e6);
    // The shifted control points are rounded themselves, by 2^-34 at most; so is the length, six differences of them.
    EXPECT_NEAR(gaussLength(BezierCurve(points), 1e-10).length, near.length, 12 * 0x1p-34);
}

// A tolerance that rounding forbids: the answer is honest about it, and bounded in work.
TEST(ArcLengthStability, AnImpossibleToleranceGivesAnHonestError) {
    for (const auto& [name, curve] : test::randomCurves(6, 60)) {
        const LengthEstimate estimate = gaussLength(curve, 1e-30);
        const test::Quad truth = test::ReferenceCurve(curve).length();
        EXPECT_LE(std::abs(static_cast<Real>(truth - estimate.length)), estimate.error) << name;
        EXPECT_LT(estimate.error, 1e-11) << name;
        EXPECT_LT(estimate.evaluations, 30'000) << name;
    }
}

// Rules against the monomials that they integrate exactly.
TEST(ArcLengthStability, GaussRulesAreExactToTheirDegree) {
    for (int points = 1; points <= 64; ++points) {
        const GaussRule rule = gaussLegendreRule(points);
        ASSERT_EQ(rule.points(), points);
        for (int power = 0; power <= 2 * points - 1; ++power) {
            Real sum = 0;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
            EXPECT_NEAR(sum, power % 2 == 0 ? Real(2) / (power + 1) : 0, 1e-14) << points << " points, x^" << power;
        }
    }
}

TEST(ArcLengthStability, RefusesArgumentsOutOfTheirDomain) {
    const BezierCurve curve = test::parabola();
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_THROW(chordLength(curve, 0), InputError);
    EXPECT_THROW(gaussLength(curve, 0), InputError);
    EXPECT_THROW(gaussLength(curve, nan), InputError);
    EXPECT_THROW(gaussLength(curve, 1e-6, -0.1, 1), InputError);
    EXPECT_THROW(gaussLength(curve, 1e-6, 0, 1.5), InputError);
    EXPECT_THROW(gaussLength(curve, 1e-6, 0.6, 0.5), InputError);
    EXPECT_THROW(gaussLength(curve, 1e-6, nan, 1), InputError);
    EXPECT_THROW(evenlySpaced(curve, 0), InputError);
    EXPECT_THROW(gaussLegendreRule(0), InputError);
}

}  // namespace
}  // namespace caustic
