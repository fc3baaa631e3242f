#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.h"
#include "curve/curve_bounds.h"
#include "support/known_curves.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

// Two maxima in one bracket: ternary search ends up at either. Fragile with whatever number of samples; exact never
// misses.
TEST(CurveBoundsStability, TernarySearchMissesOneOfTwoMaximaBetweenSamples) {
    Random random(1, {1});
    int missed = 0;
    constexpr int trials = 1000;
    for (int i = 0; i < trials; ++i) {
        const Real width = std::pow(10, random.uniform(-2, -1));
        const Real place = random.uniform(0.2, 0.8);
        const BezierCurve curve = test::twoHumps(place, width);
        const auto height = static_cast<Real>(test::ReferenceCurve(curve).position(place + 1.3 * width)[1]);
        if (sampledBounds(curve, 9).max().y() < height - 1e-12) ++missed;
        EXPECT_GE(exactBounds(curve).max().y(), height) << "pair " << i;
    }
    EXPECT_GT(missed, trials / 10) << "the fragile way is expected to fail";
    RecordProperty("missed", missed);
}

// What the test above rests on: the closed form's maxima are maxima, and the second is the higher one.
TEST(CurveBoundsStability, TwoHumpsAreWhereTheyAreSaidToBe) {
    const BezierCurve curve = test::twoHumps(0.4, 0.1);
    const auto height = [&](Real t) { return curve.position(t).y(); };
    for (const Real t : {0.3, 0.53}) {
        EXPECT_NEAR(curve.derivative(t).y(), 0, 1e-15);
        EXPECT_GT(height(t), height(t - 0.01));
        EXPECT_GT(height(t), height(t + 0.01));
    }
    EXPECT_GT(height(0.53), height(0.3));
    EXPECT_NEAR(curve.position(0.7).x(), 0.7, 1e-15);
}

TEST(CurveBoundsStability, HugeAndTinyCoordinates) {
    for (const auto& [name, curve] : test::randomCurves(2, 120)) {
        const Bounds3 box = exactBounds(curve);
        for (const int exponent : {-500, 500}) {  // a power of two changes no digit
            const Real factor = std::ldexp(1.0, exponent);
            std::vector<Vec3> points = curve.controlPoints();
            for (Vec3& point : points) point *= factor;
            const Bounds3 far = exactBounds(BezierCurve(points));
            EXPECT_LT((far.min() / factor - box.min()).norm(), 1e-14) << name;
            EXPECT_LT((far.max() / factor - box.max()).norm(), 1e-14) << name;
            const Bounds3 sampled = sampledBounds(BezierCurve(points), 20);
            EXPECT_TRUE(far.contains(sampled)) << name;
        }
    }
}

// A small curve far away: its computed points scatter by rounding, and the box holds them all.
TEST(CurveBoundsStability, ContainsComputedPointsFarFromTheOrigin) {
    for (const auto& [name, curve] : test::randomCurves(3, 60)) {
        std::vector<Vec3> points = curve.controlPoints();
        for (Vec3& point : points) point = 1e-6 * point + Vec3(1e8, -1e7, 1e9);
        const BezierCurve far(points);
        const Bounds3 box = exactBounds(far);
        for (int i = 0; i <= 1000; ++i) EXPECT_TRUE(box.contains(far.position(i / 1000.0))) << name << ", sample " << i;
    }
}

TEST(CurveBoundsStability, EveryDegreeUpTo60) {
    Random random(1, {4});
    for (int degree = 0; degree <= 60; ++degree) {
        const BezierCurve curve = test::randomCurve(random, degree);
        const Bounds3 box = exactBounds(curve);
        const test::ReferenceCurve reference(curve);
        for (int axis = 0; axis < 3; ++axis) {
            const auto [low, high] = reference.range(axis);
            EXPECT_LE(test::Quad(box.min()[axis]), low) << "degree " << degree;
            EXPECT_GE(test::Quad(box.max()[axis]), high) << "degree " << degree;
            EXPECT_LT(static_cast<Real>(low) - box.min()[axis], 1e-12) << "degree " << degree;
            EXPECT_LT(box.max()[axis] - static_cast<Real>(high), 1e-12) << "degree " << degree;
        }
    }
}

TEST(CurveBoundsStability, ASinglePointHasABoxOfRoundingsSize) {
    const Vec3 point(1, -2, 0);
    for (const std::size_t count : {1U, 2U, 61U}) {
        const BezierCurve curve(std::vector<Vec3>(count, point));
        EXPECT_TRUE(exactBounds(curve).contains(point));
        EXPECT_LT(exactBounds(curve).diagonal().norm(), 1e-12);
        // position()'s bound: 3 n u of the largest coordinate.
        const Real rounding = 3 * static_cast<Real>(count) * 0x1p-53 * 2;
        const Bounds3 sampled = sampledBounds(curve, 5);
        EXPECT_LE((sampled.min() - point).cwiseAbs().maxCoeff(), rounding);
        EXPECT_LE((sampled.max() - point).cwiseAbs().maxCoeff(), rounding);
    }
}

TEST(CurveBoundsStability, RefusesLessThanTwoSamples) {
    EXPECT_THROW(sampledBounds(test::parabola(), 1), InputError);
    EXPECT_THROW(sampledBounds(test::parabola(), -3), InputError);
}

}  // namespace
}  // namespace caustic
