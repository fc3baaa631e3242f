#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"
#include "curve/svg_arc.h"
#include "svg_paths.h"

namespace caustic {
namespace {

using test::distanceBetween;
using test::expectSamePath;
using test::number;
using test::splinesOf;

constexpr std::uint64_t seed = 20260103;
constexpr Real pi = std::numbers::pi;

Real lengthOf(const std::string& data) {
    Real length = 0;
    for (const BezierSpline& spline : splinesOf(data)) length += spline.length(1e-12).length;
    return length;
}

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
