#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "curve/svg_arc.h"
#include "svg_paths.h"

namespace caustic {
namespace {

using test::expectSamePath;
using test::number;
using test::splinesOf;

constexpr std::uint64_t seed = 20260103;
constexpr Real pi = std::numbers::pi;

struct ArcCase {
    SvgArc arc;
    std::vector<CubicPiece> pieces;
};

ArcCase randomArc(std::uint64_t i) {
    Random random(seed, {2, i});
    const auto point = [&] { return Vec2(random.uniform(-10, 10), random.uniform(-10, 10)); };
    const auto radius = [&] { return std::exp(random.uniform(-3, 6)); };
    const SvgArc arc{
        point(), {radius(), radius()}, random.uniform(-720, 720), random.below(2) == 0, random.below(2) == 0, point()};
    return {arc, arcToCubics(arc)};
}

// Undoes the ellipse: there the arc lies on a circle of radius 1.
class UnitCircle {
public:
    // The centre by the formulas of SVG 1.1, F.6.5 and F.6.6, written down here anew.
    explicit UnitCircle(const SvgArc& arc) : turn_(arc.rotation * pi / 180), radii_(arc.radii) {
        const Vec2 half = turn_.inverse() * Vec2((arc.from - arc.to) / 2);
        const Real lambda = half.cwiseQuotient(radii_).squaredNorm();
        if (lambda > 1) radii_ *= std::sqrt(lambda);
        const Real rx2 = radii_.x() * radii_.x();
        const Real ry2 = radii_.y() * radii_.y();
        const Real across = rx2 * half.y() * half.y() + ry2 * half.x() * half.x();
        const Real root = std::sqrt(std::max(Real(0), (rx2 * ry2 - across) / across));
        const Vec2 centre(root * radii_.x() * half.y() / radii_.y(), -root * radii_.y() * half.x() / radii_.x());
        centre_ = turn_ * Vec2(arc.large == arc.sweep ? -centre : centre) + (arc.from + arc.to) / 2;
    }
    Vec2 operator()(const Vec2& point) const {
        return Vec2(turn_.inverse() * Vec2(point - centre_)).cwiseQuotient(radii_);
    }

private:
    Eigen::Rotation2D<Real> turn_;
    Vec2 radii_;
    Vec2 centre_ = Vec2::Zero();
};

Real angleFrom(const Vec2& a, const Vec2& b) { return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)); }

TEST(SvgArc, LiesOnItsEllipseWithinTheStatedBound) {
    Real largest = 0;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto [arc, pieces] = randomArc(i);
        const UnitCircle circle(arc);
        // Cancellation at the centre, far away when the radii are long: an error of this test, not of the arc.
        const Real rounding = 1e-13 * (1 + 20 / arc.radii.minCoeff());
        Vec2 from = arc.from;
        for (const CubicPiece& piece : pieces) {
            const BezierCurve curve({Vec3(from.x(), from.y(), 0), Vec3(piece.control1.x(), piece.control1.y(), 0),
                                     Vec3(piece.control2.x(), piece.control2.y(), 0),
                                     Vec3(piece.end.x(), piece.end.y(), 0)});
            for (int step = 0; step <= 20; ++step) {
                const Real radius = circle(curve.position(step / 20.0).head<2>()).norm();
                ASSERT_NEAR(radius, 1, arcError + rounding) << "arc " << i;
                largest = std::max(largest, std::abs(radius - 1));
            }
            from = piece.end;
        }
        ASSERT_EQ(from, arc.to) << "arc " << i;
    }
    EXPECT_GT(largest, arcError / 2) << "the bound promises less than what holds";
}

TEST(SvgArc, FlagsChooseTheWayRound) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto [arc, pieces] = randomArc(i);
        const UnitCircle circle(arc);
        Real turn = 0;
        Vec2 from = arc.from;
        for (const CubicPiece& piece : pieces) {
            const Real angle = angleFrom(circle(from), circle(piece.end));
            EXPECT_LE(std::abs(angle), pi / 4 + 1e-6) << "arc " << i;
            turn += angle;
            from = piece.end;
        }
        EXPECT_EQ(turn > 0, arc.sweep) << "arc " << i << ": the angle grows when the sweep flag is set";
        if (arc.large) {
            EXPECT_GE(std::abs(turn), pi - 1e-6) << "arc " << i;
        } else {
            EXPECT_LE(std::abs(turn), pi + 1e-6) << "arc " << i;
        }
    }
}

TEST(SvgArc, PiecesMeetSmoothly) {
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(seed, {3, i});
        const std::string data = "M0 0A" + number(random.uniform(1, 9)) + number(random.uniform(1, 9)) +
                                 number(random.uniform(0, 360)) + "1 0 1 1";
        for (const Joint& joint : splinesOf(data).front().joints()) {
            EXPECT_EQ(joint.continuity, Continuity::C1) << data;
        }
    }
}

// SVG 1.1, F.6.2 and F.6.6.
TEST(SvgArc, OutOfRangeRadiiAreMended) {
    expectSamePath("M1 1A0 5 0 1 1 4 5", "M1 1L4 5");
    expectSamePath("M1 1A5 0 0 1 1 4 5", "M1 1L4 5");
    expectSamePath("M0 0A1 1 0 0 1 10 0", "M0 0A5 5 0 0 1 10 0");
    expectSamePath("M0 0A1 2 90 0 1 10 0", "M0 0A2.5 5 90 0 1 10 0");
    expectSamePath("M0 0A1e-320 1e-320 0 0 1 10 0", "M0 0L10 0");
    // SVG 2, 9.5.1: signs of radii are dropped.
    expectSamePath("M0 0A-5 -7 30 0 1 10 0", "M0 0A5 7 30 0 1 10 0");
    expectSamePath("M0 0A+5,-7 30 1 0 10 0", "M0 0A5 7 30 1 0 10 0");
    expectSamePath("M0 0A-0 -7 30 1 0 10 0", "M0 0L10 0");
}

TEST(SvgArc, HugeRadiiMakeFlatArcsWithoutNoise) {
    for (const Real radius : {1e3, 1e9, 1e30, 1e99}) {
        const auto pieces = arcToCubics({{0, 0}, {radius, radius}, 0, false, true, {3, 4}});
        ASSERT_EQ(pieces.size(), 1U);
        // A third of the chord, 5/3, leaves it at an angle of 2.5 / radius.
        const Real bulge = Real(25) / 6 / radius;
        EXPECT_NEAR((pieces[0].control1 - Vec2(1, Real(4) / 3)).norm(), bulge, 1e-2 * bulge + 1e-15) << radius;
        EXPECT_NEAR((pieces[0].control2 - Vec2(2, Real(8) / 3)).norm(), bulge, 1e-2 * bulge + 1e-15) << radius;
    }
}

}  // namespace
}  // namespace caustic
