#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "curve/arc_length.h"
#include "support/known_curves.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

Real distance(Real value, const test::Quad& truth) { return std::abs(static_cast<Real>(truth - value)); }

// The claim of LengthEstimate::error, on every kind of curve, cusps and loops among them.
TEST(ArcLengthProperty, GaussLengthLiesWithinItsErrorOfTheReference) {
    for (const auto& [name, curve] : test::randomCurves(1, 1000)) {
        const LengthEstimate estimate = gaussLength(curve, 1e-9);
        EXPECT_LE(distance(estimate.length, test::ReferenceCurve(curve).length()), estimate.error) << name;
        EXPECT_LE(estimate.error, 1e-9) << name;
    }
}

// Coarse tolerances stop the bisection early: the bound has to hold there as well.
TEST(ArcLengthProperty, ErrorHoldsWhateverTheTolerance) {
    for (const auto& [name, curve] : test::randomCurves(2, 60)) {
        const test::Quad truth = test::ReferenceCurve(curve).length();
        for (const Real tolerance : {10.0, 0.3, 1e-2, 1e-4, 1e-7, 1e-13}) {
            const LengthEstimate estimate = gaussLength(curve, tolerance);
            EXPECT_LE(distance(estimate.length, truth), estimate.error) << name << ", tolerance " << tolerance;
            EXPECT_LE(estimate.error, std::max(tolerance, 1e-11)) << name << ", tolerance " << tolerance;
        }
    }
}

// A polygon through points of the curve is no longer than the curve, and no shorter for a point more.
TEST(ArcLengthProperty, ChordsGrowTowardsTheLength) {
    for (const auto& [name, curve] : test::randomCurves(3, 120)) {
        const LengthEstimate estimate = gaussLength(curve, 1e-10);
        Real before = 0;
        for (const int segments : {1, 2, 4, 8, 64, 1024}) {
            const Real chords = chordLength(curve, segments);
            EXPECT_GE(chords, before - 1e-11) << name << ", " << segments << " segments";
            before = chords;
        }
        EXPECT_LE(before, estimate.length + estimate.error + 1e-11) << name;
        EXPECT_NEAR(before, estimate.length, 1e-3 * (1 + estimate.length)) << name;
    }
}

// On a smooth curve the chords' error falls with the square of their number: 4 times smaller for twice as many.
TEST(ArcLengthProperty, ChordsConvergeWithTheSquareOfTheirNumber) {
    const Real truth = test::parabolaLength(1);
    for (const int segments : {8, 32, 128}) {
        const Real coarse = truth - chordLength(test::parabola(), segments);
        const Real fine = truth - chordLength(test::parabola(), 2 * segments);
        EXPECT_NEAR(coarse / fine, 4, 0.05) << segments << " segments";
    }
}

// Lengths add up, scale with the curve, and don't depend on the direction or a rotation.
TEST(ArcLengthProperty, LengthIsAdditiveAndScalesWithTheCurve) {
    const Eigen::Matrix<Real, 3, 3> quarterTurn{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    Random random(4, {4});
    for (const auto& [name, curve] : test::randomCurves(4, 120)) {
        const LengthEstimate whole = gaussLength(curve, 1e-10);
        const Real middle = random.uniform();
        const LengthEstimate first = gaussLength(curve, 1e-10, 0, middle);
        const LengthEstimate second = gaussLength(curve, 1e-10, middle, 1);
        EXPECT_NEAR(first.length + second.length, whole.length, first.error + second.error + whole.error) << name;

        std::vector<Vec3> moved;
        for (const Vec3& point : curve.controlPoints()) moved.push_back(1000 * (quarterTurn * point));
        std::reverse(moved.begin(), moved.end());
        EXPECT_NEAR(gaussLength(BezierCurve(moved), 1e-7).length, 1000 * whole.length, 3e-7) << name;
    }
}

TEST(ArcLengthProperty, EvenlySpacedPiecesHaveEqualLengths) {
    constexpr int count = 7;
    for (const auto& [name, curve] : test::randomCurves(5, 120)) {
        const std::vector<Real> cuts = evenlySpaced(curve, count);
        ASSERT_EQ(cuts.size(), 8U) << name;
        EXPECT_TRUE(std::is_sorted(cuts.begin(), cuts.end())) << name;
        const Real total = gaussLength(curve, 1e-12).length;
        for (std::size_t i = 0; i < count; ++i) {
            const Real piece = gaussLength(curve, 1e-12, cuts[i], cuts[i + 1]).length;
            EXPECT_NEAR(piece, total / count, 1e-9 * total) << name << ", piece " << i;
        }
    }
}

}  // namespace
}  // namespace caustic
