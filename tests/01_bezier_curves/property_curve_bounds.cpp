#include <gtest/gtest.h>

#include <algorithm>

#include "curve/curve_bounds.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

// How many of the points that position() computes at evenly spaced parameters lie outside.
int outside(const Bounds3& box, const BezierCurve& curve, int samples) {
    int count = 0;
    for (int i = 0; i <= samples; ++i) {
        if (!box.contains(curve.position(static_cast<Real>(i) / samples))) ++count;
    }
    return count;
}

TEST(CurveBoundsProperty, ExactBoundsContainEverySampledPoint) {
    for (const auto& [name, curve] : test::randomCurves(1, 1000)) {
        EXPECT_EQ(outside(exactBounds(curve), curve, 10'000), 0) << name;
    }
}

TEST(CurveBoundsProperty, ExactBoundsContainAMillionSampledPoints) {
    for (const auto& [name, curve] : test::randomCurves(2, 10)) {
        EXPECT_EQ(outside(exactBounds(curve), curve, 1'000'000), 0) << name;
    }
}

// Against extrema found with 113 bits: never smaller, not by the last bit, and larger by less than 1e-9 of the
// diagonal.
TEST(CurveBoundsProperty, ExactBoundsAreTight) {
    for (const auto& [name, curve] : test::randomCurves(1, 1000)) {
        const Bounds3 box = exactBounds(curve);
        const test::ReferenceCurve reference(curve);
        test::QuadPoint low;
        test::QuadPoint high;
        test::Quad diagonal = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const test::ReferenceCurve::Range range = reference.range(static_cast<int>(axis));
            low[axis] = range.low;
            high[axis] = range.high;
            diagonal += (high[axis] - low[axis]) * (high[axis] - low[axis]);
        }
        diagonal = sqrt(diagonal);
        // A curve whose control points all coincide has a diagonal of 0; there only rounding is left.
        const test::Quad excess = std::max(test::Quad(1e-9) * diagonal, test::Quad(1e-13));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Eigen::Index>(axis);
            EXPECT_LE(test::Quad(box.min()[i]), low[axis]) << name << ", axis " << axis;
            EXPECT_GE(test::Quad(box.max()[i]), high[axis]) << name << ", axis " << axis;
            EXPECT_LT(low[axis] - box.min()[i], excess) << name << ", axis " << axis;
            EXPECT_LT(box.max()[i] - high[axis], excess) << name << ", axis " << axis;
        }
    }
}

// The report's way finds values that the curve takes, so its box can't reach beyond the exact one.
TEST(CurveBoundsProperty, SampledBoundsLieWithinTheExactOnes) {
    for (const auto& [name, curve] : test::randomCurves(3, 300)) {
        const Bounds3 exact = exactBounds(curve);
        for (const int samples : {2, 5, 33}) {
            EXPECT_TRUE(exact.contains(sampledBounds(curve, samples))) << name << ", " << samples << " samples";
        }
    }
}

// With samples enough for degree 12 both ways agree.
TEST(CurveBoundsProperty, SampledBoundsReachTheExactOnesWithManySamples) {
    for (const auto& [name, curve] : test::randomCurves(4, 300)) {
        const Bounds3 exact = exactBounds(curve);
        const Bounds3 sampled = sampledBounds(curve, 400);
        EXPECT_LT((exact.max() - sampled.max()).norm(), 1e-9) << name;
        EXPECT_LT((exact.min() - sampled.min()).norm(), 1e-9) << name;
    }
}

}  // namespace
}  // namespace caustic
