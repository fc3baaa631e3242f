#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "curve/curve_bounds.h"
#include "support/known_curves.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"
#include "support/refusal.h"

namespace caustic {
namespace {

const Real peak = std::sqrt(Real(3)) / 2;  // of test::wave()

// T₈ (2 t - 1) on a slope: four waves in height order, each between samples of its own. The coefficients of T_n are
// (-1)^(n-i) C(2n, 2i) / C(n, i) (Rababah 2003, Transformation of Chebyshev–Bernstein Polynomial Basis).
BezierCurve wavesOnASlope(Real slope) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 8; ++i) {
        Real even = 1;
        Real all = 1;
        for (int k = 0; k < 2 * i; ++k) even *= Real(16 - k) / (k + 1);
        for (int k = 0; k < i; ++k) all *= Real(8 - k) / (k + 1);
        const Real wave = (i % 2 == 0 ? 1 : -1) * even / all;
        const Real height = slope * (Real(i) / 4 - 1);
        points.emplace_back(wave + height, 3 - wave + height, -2e5 * wave + 1e5 * height);
    }
    return BezierCurve(points);
}

// Both extrema of each coordinate lie between samples; closed form in known_curves.h.
TEST(SampledBounds, FindsMinimumAndMaximumBetweenSamples) {
    const Bounds3 box = sampledBounds(test::wave(), 9);
    EXPECT_LT((box.min() - Vec3(-peak, 1 - peak, 5 - 2 * peak)).norm(), 1e-9)
        << "Is there a search for the minimum too, in every bracket where the samples turn?";
    EXPECT_LT((box.max() - Vec3(peak, 1 + peak, 5 + 2 * peak)).norm(), 1e-9)
        << "Which third goes when the left one of the two inner points is higher?";
    // y = -(t - 3/8)²: the samples at 1/4 and 1/2 are equal, to the last bit, and the maximum, 0, lies between them.
    const BezierCurve curve({Vec3(0, -9.0 / 64, 0), Vec3(1, 15.0 / 64, 0), Vec3(2, -25.0 / 64, 0)});
    EXPECT_NEAR(sampledBounds(curve, 5).max().y(), 0, 1e-12) << "Does a bracket need < on both sides?";
    const BezierCurve below({Vec3(0, 9.0 / 64, 0), Vec3(1, -15.0 / 64, 0), Vec3(2, 25.0 / 64, 0)});
    EXPECT_NEAR(sampledBounds(below, 5).min().y(), 0, 1e-12) << "And a valley?";
    for (const Real slope : {-0.11, -0.03, 0.03, 0.07, 0.11}) {
        const BezierCurve waves = wavesOnASlope(slope);
        const test::ReferenceCurve reference(waves);
        for (int samples = 11; samples <= 40; ++samples) {
            const Bounds3 found = sampledBounds(waves, samples);
            for (int axis = 0; axis < 3; ++axis) {
                const auto [low, high] = reference.range(axis);
                const Real scale = axis == 2 ? 1e5 : 1;
                ASSERT_NEAR(found.min()[axis], static_cast<Real>(low), 1e-11 * scale)
                    << samples << " samples, slope " << slope << ": from where to where does a bracket reach?";
                ASSERT_NEAR(found.max()[axis], static_cast<Real>(high), 1e-11 * scale)
                    << samples << " samples, slope " << slope << ": and which third goes?";
            }
        }
    }
}

// A monotone coordinate is extreme at the ends, where no sample turns.
TEST(SampledBounds, TakesInTheEndPoints) {
    const BezierCurve curve({Vec3(0, 5, -1), Vec3(1, 3, 0), Vec3(2, 2, 4), Vec3(4, -1, 5)});
    const Bounds3 box = sampledBounds(curve, 8);
    EXPECT_LT((box.min() - Vec3(0, -1, -1)).norm(), 1e-13) << "Where is a rising coordinate smallest?";
    EXPECT_LT((box.max() - Vec3(4, 5, 5)).norm(), 1e-13);
    for (const int few : {1, 0, -3}) {
        EXPECT_TRUE(test::refuses([&] { sampledBounds(curve, few); }, "samples", std::to_string(few)));
    }
    // A box that is nowhere near the origin, of numbers that no float holds.
    const Bounds3 away = sampledBounds(BezierCurve({Vec3(-0.1, -7.3, 0.3), Vec3(-0.7, -7.1, 1e-3)}), 7);
    EXPECT_LT((away.min() - Vec3(-0.7, -7.3, 1e-3)).norm(), 1e-14) << "Where does a coordinate below 0 end?";
    EXPECT_LT((away.max() - Vec3(-0.1, -7.1, 0.3)).norm(), 1e-14) << "Where does a coordinate below 0 end?";
    const Bounds3 ends = sampledBounds(BezierCurve({Vec3(2, 0, -7), Vec3(1, 0, 3)}), 2);
    EXPECT_LT((ends.min() - Vec3(1, 0, -7)).norm(), 1e-13) << "Two samples are the two ends.";
    EXPECT_LT((ends.max() - Vec3(2, 0, 3)).norm(), 1e-13);
    // Within the first and within the last piece: y = t (1 - 4 t) and its mirror, highest at 1/8 and 7/8.
    for (const Real side : {0.0, 1.0}) {
        const BezierCurve hump({Vec3(0, -3 * side, 0), Vec3(0, 0.5, 0), Vec3(0, -3 * (1 - side), 0)});
        EXPECT_NEAR(sampledBounds(hump, 5).max().y(), 1.0 / 16, 1e-12) << "What lies beside the sample at an end?";
        // y = t (0.2 - t) and its mirror: between an end and its only neighbour, and the end is the higher one.
        const BezierCurve steep({Vec3(0, -0.8 * side, 0), Vec3(0, 0.1, 0), Vec3(0, -0.8 * (1 - side), 0)});
        EXPECT_NEAR(sampledBounds(steep, 5).max().y(), 0.01, 1e-12) << "Is a bracket searched at either end, too?";
        // y = -(t - 1.1)² and its mirror: what turns beyond the end is not of the curve.
        const BezierCurve outside(
            {Vec3(0, side == 0 ? -0.01 : -1.21, 0), Vec3(0, -0.11, 0), Vec3(0, side == 0 ? -1.21 : -0.01, 0)});
        EXPECT_NEAR(sampledBounds(outside, 5).max().y(), -0.01, 1e-14) << "Does a bracket reach beyond the curve?";
    }
}

// Two maxima as close as 0.003, anywhere: some pairs fall between the samples of whatever grid. A hundred millionth of
// the difference in height is allowed, far more than rounding.
TEST(ExactBounds, SeesBothOfTwoCloseMaxima) {
    Random random(108, {0});
    for (int i = 0; i < 200; ++i) {
        const Real width = std::pow(10, random.uniform(-2.5, -1));
        const Real place = random.uniform(0.2, 0.8);
        const BezierCurve curve = test::twoHumps(place, width);
        const Bounds3 box = exactBounds(curve);
        for (const Real t : {place - width, place + 1.3 * width}) {
            const auto height = static_cast<Real>(test::ReferenceCurve(curve).position(t)[1]);
            EXPECT_GE(box.max().y(), height - 1e-13)
                << "t = " << t << ", the other maximum is " << 2.3 * width << " away: are all roots of y' looked at?";
        }
    }
}

// Curves of all kinds, in a space whose axes are of different lengths: rounding on one says nothing about the others.
std::vector<test::NamedCurve> lopsidedCurves() {
    std::vector<test::NamedCurve> curves = test::randomCurves(8, 36);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::vector<Vec3> points = curves[i].curve.controlPoints();
        const Real smallest = i % 2 == 0 ? 1e-6 : 1e-200;
        for (Vec3& point : points) point = Vec3(1e6 * point.x(), point.y() + 3, smallest * point.z());
        curves[i].curve = BezierCurve(points);
    }
    return curves;
}

// What position() computes, operation by operation.
Vec3 byCasteljau(const BezierCurve& curve, Real t) {
    std::vector<Vec3> points = curve.controlPoints();
    for (std::size_t left = points.size(); left > 1; --left) {
        for (std::size_t i = 0; i + 1 < left; ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
    }
    return points.front();
}

// Never smaller than the curve, not by the last bit: the judge computes with 113 bits.
TEST(ExactBounds, IsNeverSmallerThanTheCurve) {
    for (const auto& [name, curve] : lopsidedCurves()) {
        const Bounds3 box = exactBounds(curve);
        const test::ReferenceCurve reference(curve);
        for (int axis = 0; axis < 3; ++axis) {
            const auto [low, high] = reference.range(axis);
            EXPECT_LE(test::Quad(box.min()[axis]), low) << name << ", axis " << axis << ": is rounding allowed for, "
                                                        << "and are the end points in?";
            EXPECT_GE(test::Quad(box.max()[axis]), high) << name << ", axis " << axis;
        }
    }
    // So large or so small that a product under- or overflows; and so flat that position() itself wanders by rounding.
    const auto holds = [](const BezierCurve& curve, int steps, const std::string& what) {
        const Bounds3 box = exactBounds(curve);
        for (int i = 0; i <= steps; ++i) {
            const Vec3 point = byCasteljau(curve, static_cast<Real>(i) / steps);
            ASSERT_TRUE((point.array() >= box.min().array()).all() && (point.array() <= box.max().array()).all())
                << what << " at step " << i << ": by how much can a point of this degree and size be off?";
        }
    };
    for (const Real size : {1e-250, 1e-200, 1e200, 1e250}) {
        for (const auto& [name, curve] : test::randomCurves(9, 12)) {
            std::vector<Vec3> points = curve.controlPoints();
            for (Vec3& point : points) point *= size;
            ASSERT_NO_FATAL_FAILURE(holds(BezierCurve(points), 1000, name));
        }
    }
    for (const int degree : {3, 20, 100, 300}) {
        for (const Real x : {0.1, 1.0 / 3, 0.7, 0.9}) {
            const BezierCurve standing(std::vector<Vec3>(static_cast<std::size_t>(degree) + 1, Vec3(x, -x, 1e5 * x)));
            ASSERT_NO_FATAL_FAILURE(holds(standing, degree > 20 ? 400 : 4000, "degree " + std::to_string(degree)));
        }
    }
}

// The same closed form. The control points reach out to 3, the curve to 0.87.
TEST(ExactBounds, IsNoLargerThanRoundingAsks) {
    const Bounds3 box = exactBounds(test::wave());
    EXPECT_LT((box.max() - Vec3(peak, 1 + peak, 5 + 2 * peak)).maxCoeff(), 1e-9)
        << "Is it the curve's box, or that of its control points?";
    EXPECT_LT((Vec3(-peak, 1 - peak, 5 - 2 * peak) - box.min()).maxCoeff(), 1e-9);
    constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
    for (const auto& [name, curve] : lopsidedCurves()) {
        const Bounds3 whole = exactBounds(curve);
        const test::ReferenceCurve reference(curve);
        for (int axis = 0; axis < 3; ++axis) {
            Real largest = 0;
            for (const Vec3& point : curve.controlPoints()) largest = std::max(largest, std::abs(point[axis]));
            const Real allowed = 16 * (curve.degree() + 1) * unitRoundoff * largest;
            const auto [low, high] = reference.range(axis);
            EXPECT_LE(static_cast<Real>(test::Quad(whole.max()[axis]) - high), allowed)
                << name << ", axis " << axis << ": how much may the box exceed the curve, and on which axis?";
            EXPECT_LE(static_cast<Real>(low - test::Quad(whole.min()[axis])), allowed) << name << ", axis " << axis;
        }
    }
}

}  // namespace
}  // namespace caustic
