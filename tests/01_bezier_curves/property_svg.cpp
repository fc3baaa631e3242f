#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/random.h"
#include "core/text.h"
#include "curve/svg_arc.h"
#include "curve/svg_path_data.h"

namespace caustic {
namespace {

constexpr std::uint64_t seed = 20260103;
constexpr Real pi = std::numbers::pi;

std::vector<BezierSpline> splinesOf(const std::string& data, const SvgTransform& transform = SvgTransform::Identity()) {
    return parseSvgPathData(data, transform, {"test.svg", 1});
}

Real lengthOf(const std::string& data) {
    Real length = 0;
    for (const BezierSpline& spline : splinesOf(data)) length += spline.length(1e-12).length;
    return length;
}

// Greatest distance between two lists of splines of the same shape, over all control points.
Real distanceBetween(const std::vector<BezierSpline>& a, const std::vector<BezierSpline>& b) {
    constexpr Real incomparable = 1e300;
    if (a.size() != b.size()) return incomparable;
    Real largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].segments().size() != b[i].segments().size() || a[i].closed() != b[i].closed()) return incomparable;
        for (std::size_t j = 0; j < a[i].segments().size(); ++j) {
            for (std::size_t k = 0; k < 4; ++k) {
                const Vec3 difference = a[i].segments()[j].controlPoints()[k] - b[i].segments()[j].controlPoints()[k];
                largest = std::max(largest, difference.norm());
            }
        }
    }
    return largest;
}

void expectSamePath(const std::string& data, const std::string& meaning) {
    EXPECT_LE(distanceBetween(splinesOf(data), splinesOf(meaning)), 1e-12)
        << "'" << data << "' is not '" << meaning << "'";
}

std::string number(Real value) { return formatReal(value) + " "; }

// Writes the same random drawing twice: with absolute commands, and with relative ones.
class TwoWays {
public:
    explicit TwoWays(Random& random) : random_(&random) { move(); }

    void command() {
        switch (random_->below(9)) {
            case 0:
                return move();
            case 1:
                return points('L', 1);
            case 2:
                return along('H', 0);
            case 3:
                return along('V', 1);
            case 4:
                return points('C', 3);
            case 5:
                return points('S', 2);
            case 6:
                return points('Q', 2);
            case 7:
                return points('T', 1);
            default:
                return random_->below(3) == 0 ? close() : arc();
        }
    }

    std::string absolute;
    std::string relative;

private:
    void letter(char upper) {
        absolute += upper;
        relative += static_cast<char>(upper - 'A' + 'a');
    }
    Vec2 point() { return {std::round(random_->uniform(-64, 64)), std::round(random_->uniform(-64, 64))}; }
    void write(const Vec2& p) {
        absolute += number(p.x()) + number(p.y());
        relative += number(p.x() - current_.x()) + number(p.y() - current_.y());
    }
    void move() {
        letter('M');
        const Vec2 p = point();
        write(p);
        current_ = begin_ = p;
    }
    void points(char upper, int count) {
        letter(upper);
        Vec2 last = current_;
        for (int i = 0; i < count; ++i) write(last = point());
        current_ = last;
    }
    void along(char upper, int axis) {
        letter(upper);
        const Real value = point()[axis];
        absolute += number(value);
        relative += number(value - current_[axis]);
        current_[axis] = value;
    }
    void arc() {
        letter('A');
        const std::string head = number(random_->uniform(1, 99)) + number(random_->uniform(1, 99)) +
                                 number(random_->uniform(-400, 400)) + number(static_cast<Real>(random_->below(2))) +
                                 number(static_cast<Real>(random_->below(2)));
        absolute += head;
        relative += head;
        const Vec2 end = point();
        write(end);
        current_ = end;
    }
    void close() {
        letter('Z');
        current_ = begin_;
    }

    Random* random_;
    Vec2 begin_ = Vec2::Zero();
    Vec2 current_ = Vec2::Zero();
};

// Coordinates are whole numbers, so adding up relative ones is exact, and both drawings are the same to the last bit.
TEST(SvgPathData, RelativeCommandsDrawWhatAbsoluteOnesDo) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(seed, {1, i});
        TwoWays drawing(random);
        for (int command = 0; command < 12; ++command) drawing.command();
        ASSERT_EQ(distanceBetween(splinesOf(drawing.absolute), splinesOf(drawing.relative)), 0)
            << drawing.absolute << "\n"
            << drawing.relative;
    }
}

// SVG 1.1, 8.3.2: coordinates after those of a move are lines; 8.3.3: after z the current point is the beginning.
TEST(SvgPathData, CommandsMeanWhatTheStandardSays) {
    expectSamePath("M1 2 3 4 5 6", "M1 2L3 4L5 6");
    expectSamePath("m1 2 3 4 5 6", "M1 2L4 6L9 12");
    expectSamePath("M0 0 L5 0 5 5 z l1 1", "M0 0 L5 0 L5 5 L0 0 z M0 0 L1 1");
    expectSamePath("M3 3 h4 v4 z m1 1 l1 0", "M3 3 L7 3 L7 7 z M4 4 L5 4");
    expectSamePath("M1 1 H2 3 V2 3", "M1 1 L2 1 L3 1 L3 2 L3 3");
    expectSamePath("M0 0C1 1 2 1 3 0S5 -1 6 0", "M0 0C1 1 2 1 3 0C4 -1 5 -1 6 0");
    expectSamePath("M0 0S5 -1 6 0", "M0 0C0 0 5 -1 6 0");
    expectSamePath("M0 0L3 0S5 -1 6 0", "M0 0L3 0C3 0 5 -1 6 0");
    expectSamePath("M0 0Q1 1 2 0T4 0T6 0", "M0 0Q1 1 2 0Q3 -1 4 0Q5 1 6 0");
    expectSamePath("M0 0T4 0T6 0", "M0 0Q0 0 4 0Q8 0 6 0");
    expectSamePath("M0 0C1 1 2 1 3 0T6 0", "M0 0C1 1 2 1 3 0Q3 0 6 0");
    expectSamePath("M0 0Q1 1 3 0S5 -1 6 0", "M0 0Q1 1 3 0C3 0 5 -1 6 0");
    expectSamePath("M0 0Q1 1 3 0z t1 1", "M0 0Q1 1 3 0L0 0z M0 0Q0 0 1 1");
}

TEST(SvgPathData, NumbersNeedNoSeparatorsWhereTheyCantBeMistaken) {
    expectSamePath("M1e-2.5.5.5", "M 0.01 0.5 L 0.5 0.5");
    expectSamePath("M-1-2+3-.5e1", "M -1 -2 L 3 -5");
    expectSamePath("M0 0a1 1 0 0110 10", "M 0 0 a 1 1 0 0 1 10 10");
    expectSamePath("M0,0a25,50,-30,0,1,50,-25", "M0 0A25 50 -30 0 1 50 -25");
    expectSamePath("\n M\t0\r\n,0L1E2,1e+0 ", "M0 0L100 1");
}

TEST(SvgPathData, WhatDrawsNothingIsNoSpline) {
    for (const char* data : {"", "  \n ", "M1 1", "m 1 1 z", "M1 1 M2 2 z z", "M0 0 A1 1 0 0 0 0 0"}) {
        EXPECT_TRUE(splinesOf(data).empty()) << data;
    }
    EXPECT_EQ(splinesOf("M1 1 L1 1").size(), 1U) << "a line of length zero is drawn: it has caps";
}

TEST(SvgPathData, CloseDrawsALineUnlessThePathIsBackAlready) {
    EXPECT_EQ(splinesOf("M0 0 L1 0 L1 1 z").front().segments().size(), 3U);
    EXPECT_EQ(splinesOf("M0 0 L1 0 L1 1 L0 0 z").front().segments().size(), 3U);
    // 0.1 + 0.2 - 0.3 is not 0 in double; a joint of length 1e-17 would have any direction.
    const BezierSpline back = splinesOf("m0 0 l.1 0 .2 0 0 1 -.3 -1z").front();
    EXPECT_EQ(back.segments().size(), 4U);
    EXPECT_EQ(back.segments().back().controlPoints().back(), back.segments().front().controlPoints().front());
    EXPECT_FALSE(splinesOf("M0 0 L1 0 L1 1 L0 0").front().closed()) << "only z closes";
}

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

// A circle's length is 2 pi r. Radially a piece is off by at most arcError, and its speed by as little.
TEST(SvgLength, OfCircles) {
    for (const Real radius : {1e-3, 1.0, 7.5, 1e6}) {
        const std::string r = number(radius);
        const std::string data = "M" + r + "0 A" + r + r + "0 1 1 -" + r + "0 A" + r + r + "0 1 1 " + r + "0 z";
        EXPECT_NEAR(lengthOf(data) / (2 * pi * radius), 1, arcError) << radius;
    }
}

// An ellipse's is 4 a E(e), e² = 1 - (b/a)², with the complete elliptic integral of the second kind.
TEST(SvgLength, OfEllipsesAtAnyAngle) {
    for (const Real b : {0.9, 0.5, 0.1}) {
        for (const Real rotation : {0.0, 30.0, -77.0}) {
            const Vec2 end = 2 * Vec2(std::cos(rotation * pi / 180), std::sin(rotation * pi / 180));
            const std::string head = "a1 " + number(b) + number(rotation) + "1 1 ";
            const std::string data =
                "M0 0" + head + number(end.x()) + number(end.y()) + head + number(-end.x()) + number(-end.y());
            const Real expected = 4 * std::comp_ellint_2(std::sqrt(1 - b * b));
            EXPECT_NEAR(lengthOf(data) / expected, 1, arcError) << b << ", " << rotation;
        }
    }
}

// Arc length of y = x² from 0 to 1: (2 sqrt 5 + asinh 2) / 4. It is the quadratic with control point (1/2, 0).
TEST(SvgLength, OfAParabola) {
    EXPECT_NEAR(lengthOf("M0 0Q.5 0 1 1"), (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4, 1e-14);
}

TEST(SvgLength, OfRectanglesInAllCommands) {
    EXPECT_NEAR(lengthOf("M1 1H4V5H1z M0 0h3v4h-3v-4"), 28, 1e-13) << "two subpaths count, the move between them not";
}

// An affine map takes a Bézier curve to the curve of the mapped control points.
TEST(SvgTransform, CommutesWithEvaluation) {
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random random(seed, {4, i});
        TwoWays drawing(random);
        for (int command = 0; command < 8; ++command) drawing.command();
        SvgTransform transform;
        for (Real& entry : transform.matrix().reshaped()) entry = random.uniform(-2, 2);
        const auto plain = splinesOf(drawing.absolute);
        const auto mapped = splinesOf(drawing.absolute, transform);
        ASSERT_EQ(plain.size(), mapped.size());
        for (std::size_t j = 0; j < plain.size(); ++j) {
            const Real u = random.uniform(0, static_cast<Real>(plain[j].segments().size()));
            const Vec2 expected = transform * Vec2(plain[j].position(u).head<2>());
            EXPECT_LE((mapped[j].position(u).head<2>() - expected).norm(), 1e-11) << drawing.absolute;
        }
    }
}

}  // namespace
}  // namespace caustic
