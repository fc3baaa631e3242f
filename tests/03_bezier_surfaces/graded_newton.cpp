#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"
#include "support/in_cube.h"
#include "surface/newton.h"

namespace caustic {
namespace {

using test::inCube;

// B = size (u, v, w(u, v)): a sheet, bounded in both parameters.
class Sheet final : public ParametricSurface {
public:
    explicit Sheet(Real size = 1) : size_(size) {}

    SurfaceJet evaluate(Real u, Real v) const override {
        ++evaluations;
        return {size_ * Vec3(u, v, 0.2 * u * u - 0.1 * v), size_ * Vec3(1, 0, 0.4 * u), size_ * Vec3(0, 1, -0.1)};
    }
    bool closedInV() const override { return false; }

    mutable int evaluations = 0;

private:
    Real size_;
};

// The ray's ends are no business of Newton's method: the equation knows a line. Each of these ends short of the
// meeting.
TEST(Newton, MeetsTheSurfaceFromNearby) {
    for (const Real size : {1e-6, 1.0, 1e6}) {
        const Sheet sheet(size);
        for (std::uint64_t i = 0; i < 200; ++i) {
            Random random(1, {i});
            const Real u = random.uniform(0.1, 0.9);
            const Real v = random.uniform(0.1, 0.9);
            const Vec3 at = sheet.evaluate(u, v).point;
            const Vec3 from = at + size * (Vec3(0.3, -0.2, 2) + 0.5 * inCube(random));
            const Ray ray = {from, (at - from) / 2.5, 0, 1};
            const auto found = newtonMeeting(sheet, ray, {2.3, u + 0.05, v - 0.05}, {0.3, 10, 1e-10 * size});
            ASSERT_TRUE(found)
                << "Ray " << i << ", size " << size
                << ": in which direction does the step go, and is any number of the code meant for size 1?";
            ASSERT_NEAR(found->t, 2.5, 1e-8);
            ASSERT_NEAR(found->u, u, 1e-8) << "Which determinant belongs to which parameter?";
            ASSERT_NEAR(found->v, v, 1e-8);
        }
    }
}

// Turned around the y axis: x = 1 + u²/2 is the radius, y = u the height, v the angle in turns.
class Turned final : public ParametricSurface {
public:
    SurfaceJet evaluate(Real u, Real v) const override {
        constexpr Real turn = 2 * std::numbers::pi;
        const Real c = std::cos(turn * v);
        const Real s = std::sin(turn * v);
        const Real x = 1 + u * u / 2;
        return {{x * c, u, x * s}, {u * c, 1, u * s}, {-turn * x * s, 0, turn * x * c}};
    }
    bool closedInV() const override { return true; }
};

// What is outside of [0, 1] is no part of the surface, though the equation has a solution there. 0 and 1 are part of
// it.
TEST(Newton, MeetingsOutsideTheDomainDontCount) {
    const Sheet sheet;
    for (const Vec2& uv : {Vec2(1.1, 0.5), Vec2(-0.1, 0.5), Vec2(0.5, 1.1), Vec2(0.5, -0.1)}) {
        const Ray ray = {sheet.evaluate(uv.x(), uv.y()).point + Vec3(0, 0, 1), Vec3(0, 0, -1)};
        EXPECT_FALSE(newtonMeeting(sheet, ray, {1, 0.5, 0.5})) << "May the iteration end where it likes?";
    }
    for (const Vec2& uv : {Vec2(0, 0.5), Vec2(1, 0.5), Vec2(0.5, 0), Vec2(0.5, 1)}) {
        const Ray ray = {sheet.evaluate(uv.x(), uv.y()).point + Vec3(0, 0, 1), Vec3(0, 0, -1)};
        EXPECT_TRUE(newtonMeeting(sheet, ray, {1, uv.x(), uv.y()}))
            << "u, v = " << uv.transpose() << ": does the border belong to the surface?";
    }
    for (const Real v : {-0.5, 0.5, 1.5}) {
        const auto found = newtonMeeting(Turned(), {Vec3(-3, 0.5, 0), Vec3(1, 0, 0)}, {2, 0.49, v + 0.01});
        ASSERT_TRUE(found) << "A surface of revolution has no border in v.";
        EXPECT_NEAR(found->t, 3 - 1.125, 1e-9);
    }
}

// A plane of skew parameters: F is linear, so a single step solves it to the last digits. The plane may begin at the
// ray.
TEST(Newton, OneStepSolvesAPlane) {
    class Plane final : public ParametricSurface {
    public:
        SurfaceJet evaluate(Real u, Real v) const override {
            const Vec3 du(1.3, 0.2, -0.4);
            const Vec3 dv(-0.3, 0.9, 0.6);
            return {Vec3(-0.4, 0.3, 0.2) + u * du + v * dv, du, dv};
        }
        bool closedInV() const override { return false; }
    };
    const Plane plane;
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random(5, {i});
        const Vec3 at = plane.evaluate(random.uniform(), random.uniform()).point;
        const Vec3 direction = Vec3(0.3, -0.5, 1) + 0.3 * inCube(random);
        const Real t = random.uniform(0.01, 3);
        const NewtonPoint start = {random.uniform(0, 3), random.uniform(), random.uniform()};
        ASSERT_TRUE(newtonMeeting(plane, {at - t * direction, direction}, start, {0.3, 1, 1e-12}))
            << "Ray " << i << ": what does Cramer's rule make of a linear equation?";
    }
    const Sheet sheet;
    const auto found = newtonMeeting(sheet, {Vec3(0, 0.5, -0.05), Vec3(0, 0, 4)}, {1, 0, 0.5});
    ASSERT_TRUE(found) << "Is a meeting at t = 0 behind the ray?";
    EXPECT_EQ(found->t, 0);
}

TEST(Newton, LeavesWhenItStraysOrLooksBehind) {
    const Sheet sheet;
    const auto stepsOf = [&](const Ray& ray) {
        sheet.evaluations = 0;
        EXPECT_FALSE(newtonMeeting(sheet, ray, {1, 0.5, 0.5}));
        return sheet.evaluations;
    };
    for (const Real place : {-4.0, 5.0}) {
        EXPECT_LE(stepsOf({Vec3(place, 0.5, 1), Vec3(0, 0, -1)}), 2) << "Is u looked at after each step?";
        EXPECT_LE(stepsOf({Vec3(0.5, place, 1), Vec3(0, 0, -1)}), 2) << "Is v looked at after each step?";
    }
    EXPECT_LE(stepsOf({Vec3(0.5, 0.5, 3), Vec3(0, 0, 1)}), 2) << "Is t looked at after each step?";
    EXPECT_LE(stepsOf({Vec3(0.5, 0.25, 3), Vec3(1, 0, 0.2)}), 2)
        << "A ray along the tangent plane: what comes of a division by zero, and which comparisons does NaN pass?";
}

// B = (u², v, 0) and its three turned images. From p = 0.4 towards p² = 0.81 the first step overshoots to 1.2125.
class Bowed final : public ParametricSurface {
public:
    Bowed(bool alongU, bool fromZero) : alongU_(alongU), fromZero_(fromZero) {}

    SurfaceJet evaluate(Real u, Real v) const override {
        const Real p = fromZero_ ? (alongU_ ? u : v) : 1 - (alongU_ ? u : v);
        const Real slope = fromZero_ ? 2 * p : -2 * p;
        if (alongU_) return {{p * p, v, 0}, {slope, 0, 0}, {0, 1, 0}};
        return {{u, p * p, 0}, {1, 0, 0}, {0, slope, 0}};
    }
    bool closedInV() const override { return false; }

private:
    bool alongU_;
    bool fromZero_;
};

TEST(Newton, MayStrayAsFarAsTheLimitSays) {
    for (const bool alongU : {true, false}) {
        for (const bool fromZero : {true, false}) {
            const Bowed surface(alongU, fromZero);
            const Ray ray = {alongU ? Vec3(0.81, 0.5, 1) : Vec3(0.5, 0.81, 1), Vec3(0, 0, -1)};
            const Real from = fromZero ? 0.4 : 0.6;
            const NewtonPoint start = {0.5, alongU ? from : 0.5, alongU ? 0.5 : from};
            EXPECT_TRUE(newtonMeeting(surface, ray, start))
                << "0.2125 beyond an end it is not lost yet: may u and v leave [0, 1] on the way?";
            EXPECT_FALSE(newtonMeeting(surface, ray, start, {0.2, 10, 1e-10})) << "Whose limit is limits.stray?";
            EXPECT_TRUE(newtonMeeting(surface, ray, start, {0.22, 10, 1e-10}));
        }
    }
}

// The line touches the surface z = 1 + d², d = u - 0.5: each step halves d, and the gap that it leaves is d².
class Valley final : public ParametricSurface {
public:
    SurfaceJet evaluate(Real u, Real v) const override {
        ++evaluations;
        const Real d = u - 0.5;
        return {{u, v, 1 + d * d}, {1, 0, 2 * d}, {0, 1, 0}};
    }
    bool closedInV() const override { return false; }
    mutable int evaluations = 0;
};

TEST(Newton, EndsByTheToleranceAndTheNumberOfSteps) {
    const Valley valley;
    const Ray touching = {Vec3(-1, 0.5, 1), Vec3(1, 0, 0)};
    for (const int steps : {1, 4, 10, 17}) {
        const Real d = 0.4 * std::pow(0.5, steps);
        const NewtonPoint start = {1.5, 0.9, 0.5};
        const auto found = newtonMeeting(valley, touching, start, {0.3, steps, 1.1 * d * d});
        ASSERT_TRUE(found) << steps << " steps are allowed and enough: is the gap looked at after the last one, too?";
        EXPECT_NEAR(found->u, 0.5 + d, 1e-9) << "The gap was small enough after " << steps << " steps.";
        EXPECT_FALSE(newtonMeeting(valley, touching, start, {0.3, steps - 1, 1.1 * d * d}))
            << steps - 1 << " steps are allowed: how many does the loop take?";
        EXPECT_FALSE(newtonMeeting(valley, touching, start, {0.3, steps, 0.9 * d * d}))
            << "Is it limits.tolerance that the gap is held against, as a length?";
    }
    EXPECT_TRUE(newtonMeeting(valley, touching, {2, 1, 0.5}, {0.3, 0, 0.25})) << "A gap of 0.25 is within 0.25.";
    // 1e-4 below its lowest line d -> (d - 1e-4 / d) / 2, which from d = 0.01 / sqrt(3) jumps to -d and back for dozens
    // of steps, until rounding ends it: ten are enough to know.
    valley.evaluations = 0;
    const auto never = newtonMeeting(valley, {Vec3(-1, 0.5, 0.9999), Vec3(1, 0, 0)},
                                     {1.5, 0.5 + 0.01 / std::sqrt(3.0), 0.5}, {1e9, 10, 1e-10});
    EXPECT_FALSE(never);
    EXPECT_LE(valley.evaluations, 12) << "When does the iteration give up?";
}

}  // namespace
}  // namespace caustic
