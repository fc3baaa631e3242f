#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/random.h"
#include "curve/bezier_spline.h"
#include "curve/profile_limits.h"

namespace caustic {
namespace {

constexpr std::uint64_t seed = 20260101;

Vec3 randomPoint(Random& random) { return {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10)}; }

std::vector<Vec3> randomPoints(Random& random, std::size_t count) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(randomPoint(random));
    return points;
}

BezierCurve line(const Vec3& from, const Vec3& to) { return BezierCurve({from, to}); }

// Raising the degree is an identity of polynomials (Farin, ch. 6.1), so positions differ by rounding alone.
TEST(BezierSpline, RaisingTheDegreeMovesNoPoint) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(seed, {1, i});
        const BezierCurve low(randomPoints(random, 1 + i % 4));
        const BezierSpline spline({low});
        ASSERT_EQ(spline.segments().front().degree(), 3);
        for (const Real t : {0.0, 0.1, 0.5, random.uniform(), 1.0}) {
            EXPECT_LE((spline.position(t) - low.position(t)).norm(), 1e-13)
                << "degree " << low.degree() << ", t = " << t << ": are the weights i/(n+1) and 1 - i/(n+1)?";
        }
    }
}

TEST(BezierSpline, SegmentIOfItCoversUFromIToIPlusOne) {
    Random random(seed, {2});
    const BezierSpline spline = BezierSpline::fromControlPoints(randomPoints(random, 3 * 5 + 1));
    for (std::size_t i = 0; i < 5; ++i) {
        for (int step = 0; step < 10; ++step) {
            const Real t = step / 10.0;
            const Real u = static_cast<Real>(i) + t;
            EXPECT_LE((spline.position(u) - spline.segments()[i].position(u - static_cast<Real>(i))).norm(), 0) << u;
        }
    }
    EXPECT_EQ(spline.position(0), spline.segments().front().controlPoints().front());
    EXPECT_EQ(spline.position(5), spline.segments().back().controlPoints().back());
}

TEST(BezierSpline, OutsideItsRangeTheEndPolynomialsGoOn) {
    Random random(seed, {3});
    const BezierSpline spline = BezierSpline::fromControlPoints(randomPoints(random, 7));
    EXPECT_EQ(spline.position(-0.5), spline.segments().front().position(-0.5));
    EXPECT_EQ(spline.position(3.25), spline.segments().back().position(2.25));
}

// Both halves of a polynomial cut at t run over the same curve, at speeds t and 1 - t of the whole.
TEST(BezierSpline, ACurveCutInTwoIsC1InTheMiddleAndG1Elsewhere) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(seed, {4, i});
        const BezierCurve whole(randomPoints(random, 4));
        const auto [first, second] = whole.split(0.5);
        const Joint even = BezierSpline({first, second}).joints().front();
        EXPECT_EQ(even.continuity, Continuity::C1) << "case " << i << ", difference " << even.derivativeDifference;

        const Real t = random.uniform(0.2, 0.4);
        const auto [brief, rest] = whole.split(t);
        const Joint uneven = BezierSpline({brief, rest}).joints().front();
        EXPECT_EQ(uneven.continuity, Continuity::G1) << "case " << i << ", angle " << uneven.angle.value_or(-1);
        const Real speed = whole.derivative(t).norm();
        EXPECT_NEAR(uneven.derivativeDifference, (1 - 2 * t) * speed, 1e-11);
    }
}

// Two lines that meet at a known angle: the report gives that angle, to full precision also when it is tiny.
TEST(BezierSpline, ACornerIsC0AndItsAngleIsTheTurn) {
    for (const Real angle : {1e-9, 1e-4, 2e-3, 0.5, std::numbers::pi / 2, 3.0, std::numbers::pi}) {
        const Vec3 corner(2, 1, 0);
        const Vec3 onwards(std::cos(angle), std::sin(angle), 0);
        const BezierSpline spline({line({1, 1, 0}, corner), line(corner, corner + onwards)});
        const Joint joint = spline.joints().front();
        ASSERT_TRUE(joint.angle.has_value());
        EXPECT_NEAR(*joint.angle, angle, 1e-14) << "does the angle come from an arc cosine?";
        EXPECT_EQ(joint.continuity, angle > 1e-3 ? Continuity::C0 : Continuity::C1) << angle;
    }
}

TEST(BezierSpline, AGapIsReportedWithItsWidthHoweverSmoothTheRestWouldBe) {
    const BezierSpline spline({line({0, 0, 0}, {1, 0, 0}), line({1.25, 0, 0}, {2.25, 0, 0})});
    const Joint joint = spline.joints().front();
    EXPECT_EQ(joint.continuity, Continuity::Gap);
    EXPECT_EQ(joint.distance, 0.25);
    EXPECT_EQ(*joint.angle, 0);
    EXPECT_FALSE(spline.controlPoints().has_value()) << "3n + 1 points can't describe a gap";
}

TEST(BezierSpline, TolerancesDecideWhatCounts) {
    const BezierSpline spline({line({0, 0, 0}, {1, 0, 0}), line({1.25, 0, 0}, {2.5, 0, 0})});
    EXPECT_EQ(spline.joints({0.01, 1e-3, 1e-3}).front().continuity, Continuity::Gap);
    EXPECT_EQ(spline.joints({0.2, 1e-3, 1e-3}).front().continuity, Continuity::G1);
    EXPECT_EQ(spline.joints({0.2, 1e-3, 0.5}).front().continuity, Continuity::C1);
}

// A control point on top of its end point makes the derivative vanish there: the tangent is the limit's, so a smooth
// joint is still G1, and it isn't C1, for one side stands still.
TEST(BezierSpline, AVanishingDerivativeLeavesTheTangent) {
    const BezierCurve stopping({Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(3, 0, 0), Vec3(3, 0, 0)});
    const Vec3 direction = Vec3(2, -1, 0) / 3;
    const BezierCurve onwards({Vec3(3, 0, 0), Vec3(3, 0, 0) + direction, Vec3(5, 1, 0), Vec3(6, 0, 0)});
    const Joint joint = BezierSpline({stopping, onwards}).joints().front();
    EXPECT_EQ(joint.continuity, Continuity::G1);
    EXPECT_NEAR(*joint.angle, 0, 1e-12);
}

TEST(BezierSpline, ASegmentThatIsASinglePointHasNoTangentAndSoNoAngle) {
    const Vec3 point(1, 2, 3);
    const BezierSpline spline({line({0, 0, 0}, point), BezierCurve({point})});
    const Joint joint = spline.joints().front();
    EXPECT_EQ(joint.continuity, Continuity::C0);
    EXPECT_FALSE(joint.angle.has_value());
}

TEST(BezierSpline, OnlyAClosedSplineHasAClosingJoint) {
    const std::vector<Vec3> corners = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
    const auto triangle = [&](bool closed) {
        return BezierSpline({line(corners[0], corners[1]), line(corners[1], corners[2]), line(corners[2], corners[0])},
                            closed);
    };
    EXPECT_EQ(triangle(false).joints().size(), 2U);
    const auto joints = triangle(true).joints();
    ASSERT_EQ(joints.size(), 3U);
    EXPECT_NEAR(*joints[2].angle, std::numbers::pi / 2, 1e-14) << "is the last joint the one of segments n-1 and 0?";
    EXPECT_EQ(BezierSpline({line(corners[0], corners[1])}, true).joints().front().continuity, Continuity::Gap);
}

// A 3-4-5 triangle.
TEST(BezierSpline, LengthIsTheSumOfTheSegments) {
    const BezierSpline spline({line({0, 0, 0}, {4, 0, 0}), line({4, 0, 0}, {0, 3, 0}), line({0, 3, 0}, {0, 0, 0})});
    const LengthEstimate length = spline.length(1e-9);
    EXPECT_NEAR(length.length, 12, length.error);
    EXPECT_LE(length.error, 1e-9);
    EXPECT_GT(length.evaluations, 0);
}

TEST(BezierSpline, BoundsContainEveryPoint) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(seed, {5, i});
        const BezierSpline spline = BezierSpline::fromControlPoints(randomPoints(random, 3 * 4 + 1));
        const Bounds3 box = spline.bounds();
        for (int step = 0; step <= 1000; ++step) {
            ASSERT_TRUE(box.contains(spline.position(4 * step / 1000.0))) << "case " << i << ", step " << step;
        }
    }
}

TEST(BezierSpline, NoOverflowUpToTheLargestCoordinateAndNoUnderflowOfTheSmallest) {
    for (const Real size : {largestCoordinate, 1e-100, std::numeric_limits<Real>::denorm_min()}) {
        const BezierSpline spline({BezierCurve({Vec3(-size, 0, size), Vec3(size, -size, 0), Vec3(0, size, -size)}),
                                   line({0, size, -size}, {-size, 0, size})},
                                  true);
        const LengthEstimate length = spline.length(1e-9 * size + std::numeric_limits<Real>::denorm_min());
        EXPECT_TRUE(std::isfinite(length.length) && std::isfinite(length.error)) << size;
        EXPECT_GT(length.length, size) << size;
        for (const Joint& joint : spline.joints()) {
            EXPECT_TRUE(std::isfinite(joint.distance) && std::isfinite(joint.derivativeDifference)) << size;
            EXPECT_NE(joint.continuity, Continuity::Gap) << size;
        }
        EXPECT_TRUE(spline.bounds().diagonal().allFinite()) << size;
    }
}

TEST(BezierSpline, ControlPointsComeBackAsTheyWere) {
    Random random(seed, {6});
    const std::vector<Vec3> points = randomPoints(random, 10);
    EXPECT_EQ(BezierSpline::fromControlPoints(points).controlPoints(), points);
}

TEST(BezierSpline, BadInputIsRefused) {
    Random random(seed, {7});
    EXPECT_THROW(BezierSpline({}), InputError);
    EXPECT_THROW(BezierSpline({BezierCurve(randomPoints(random, 5))}), InputError) << "degree 4 is not cubic";
    EXPECT_THROW(BezierSpline({line({0, 0, 0}, {1e101, 0, 0})}), InputError);
    for (const std::size_t count : {0U, 1U, 2U, 3U, 5U, 6U, 8U}) {
        EXPECT_THROW(BezierSpline::fromControlPoints(randomPoints(random, count)), InputError) << count;
    }
}

}  // namespace
}  // namespace caustic
