#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "support/in_cube.h"
#include "surface/newton.h"
#include "surface/revolved_curve.h"

namespace caustic {
namespace {

using test::inCube;

// B = (u, v, w(u, v)): a sheet, bounded in both parameters.
class Sheet final : public ParametricSurface {
public:
    SurfaceJet evaluate(Real u, Real v) const override {
        ++evaluations;
        return {{u, v, 0.2 * u * u - 0.1 * v}, {1, 0, 0.4 * u}, {0, 1, -0.1}};
    }
    bool closedInV() const override { return false; }

    mutable int evaluations = 0;
};

BezierCurve cubic() { return BezierCurve({Vec3(0.6, -1, 0), Vec3(1.2, -0.4, 0), Vec3(0.3, 0.3, 0), Vec3(0.8, 1, 0)}); }

TEST(Newton, MeetsTheSurfaceFromNearby) {
    const Sheet sheet;
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(1, {i});
        const Real u = random.uniform(0.1, 0.9);
        const Real v = random.uniform(0.1, 0.9);
        const Vec3 at = sheet.evaluate(u, v).point;
        const Vec3 from = at + Vec3(0.3, -0.2, 2) + 0.5 * inCube(random);
        const Ray ray = {from, (at - from) / 2.5};
        const auto found = newtonMeeting(sheet, ray, {2.3, u + 0.05, v - 0.05});
        ASSERT_TRUE(found) << "Ray " << i << ": in which direction does the step go?";
        EXPECT_NEAR(found->t, 2.5, 1e-8);
        EXPECT_NEAR(found->u, u, 1e-8) << "Which determinant belongs to which parameter?";
        EXPECT_NEAR(found->v, v, 1e-8);
    }
}

// What is outside of [0, 1] is no part of the surface, though the equation has a solution there.
TEST(Newton, MeetingsOutsideTheDomainDontCount) {
    const Sheet sheet;
    for (const Vec2& uv : {Vec2(1.1, 0.5), Vec2(-0.1, 0.5), Vec2(0.5, 1.1), Vec2(0.5, -0.1)}) {
        const Vec3 at(uv.x(), uv.y(), 0.2 * uv.x() * uv.x() - 0.1 * uv.y());
        const Ray ray = {at + Vec3(0, 0, 1), Vec3(0, 0, -1)};
        EXPECT_FALSE(newtonMeeting(sheet, ray, {1, 0.5, 0.5})) << "May the iteration end where it likes?";
    }
    const RevolvedCurve curve(cubic(), 1);
    const Vec3 at = curve.evaluate(0.5, 0.5).point;
    EXPECT_TRUE(newtonMeeting(curve, {at - Vec3(1, 0, 0), Vec3(1, 0, 0)}, {1, 0.49, 1.51}))
        << "A surface of revolution has no border in v.";
}

TEST(Newton, LeavesWhenItStraysOrLooksBehind) {
    const Sheet sheet;
    const Ray beside = {Vec3(5, 0.5, 1), Vec3(0, 0, -1)};
    EXPECT_FALSE(newtonMeeting(sheet, beside, {1, 0.5, 0.5}));
    EXPECT_LE(sheet.evaluations, 2) << "Is u looked at after each step?";
    sheet.evaluations = 0;
    const Ray behind = {Vec3(0.5, 0.5, 3), Vec3(0, 0, 1)};
    EXPECT_FALSE(newtonMeeting(sheet, behind, {1, 0.5, 0.5}));
    EXPECT_LE(sheet.evaluations, 2) << "Is t looked at after each step?";
}

// The ray passes 1e-4 below the lowest line of a valley. There d -> (d - 1e-4 / d) / 2, which from d = 0.01 / sqrt(3)
// jumps to -d and back for dozens of steps, until rounding ends it: ten are enough to know.
TEST(Newton, GivesUpAfterTenIterations) {
    class Wall final : public ParametricSurface {
    public:
        SurfaceJet evaluate(Real u, Real v) const override {
            ++evaluations;
            const Real d = u - 0.5;
            return {{u, v, 1 + d * d}, {1, 0, 2 * d}, {0, 1, 0}};
        }
        bool closedInV() const override { return false; }
        mutable int evaluations = 0;
    };
    const Wall wall;
    const auto found = newtonMeeting(wall, {Vec3(-1, 0.5, 0.9999), Vec3(1, 0, 0)},
                                     {1.5, 0.5 + 0.01 / std::sqrt(3.0), 0.5}, {1e9, 10, 1e-10});
    EXPECT_FALSE(found);
    EXPECT_LE(wall.evaluations, 12) << "When does the iteration give up?";
}

// A ray through the axis at that height passes each circle at two places; between two samples it is inside, then
// outside.
TEST(Bracketing, StartsLieAroundEachMeeting) {
    const RevolvedCurve curve(cubic(), 64);
    int meetings = 0;
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random random(2, {i});
        const Vec3 from = 2.5 * inCube(random);
        const Ray ray = {from, inCube(random) - from};
        // The truth: the profile in small steps; at each, where the ray crosses the plane of rotation.
        constexpr int steps = 4096;
        int expected = 0;
        bool before = false;
        for (int k = 0; k <= steps; k += 64) {
            const Vec3 p = cubic().position(Real(k) / steps);
            const Vec3 at = ray.at((p.y() - ray.origin.y()) / ray.direction.y());
            const bool inside = std::hypot(at.x(), at.z()) < p.x();
            expected += k > 0 && inside != before ? 1 : 0;
            before = inside;
        }
        const NewtonStarts starts = curve.bracketingStarts(ray);
        ASSERT_EQ(starts.count, static_cast<std::size_t>(2 * expected))
            << "Ray " << i << ": is there a start on either side of each change?";
        meetings += expected;
    }
    EXPECT_GT(meetings, 200);
}

// Each start is a point of the ray in the plane of its sample's circle, and v its angle.
TEST(Bracketing, StartsAreWhereTheRayCrossesThePlaneOfRotation) {
    const RevolvedCurve curve(cubic(), 16);
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random random(3, {i});
        const Vec3 from = 2.5 * inCube(random);
        const Ray ray = {from, inCube(random) - from};
        const NewtonStarts starts = curve.bracketingStarts(ray);
        for (std::size_t k = 0; k < starts.count; ++k) {
            const NewtonPoint& start = starts.start[k];
            const Vec3 onRay = ray.at(start.t);
            const Vec3 onSurface = curve.evaluate(start.u, start.v).point;
            EXPECT_NEAR(onRay.y(), onSurface.y(), 1e-12) << "At which t does the ray reach the sample's height?";
            const Real aside = onRay.x() * onSurface.z() - onRay.z() * onSurface.x();
            EXPECT_NEAR(aside, 0, 1e-12) << "Which angle has the ray's point?";
            EXPECT_GT(onRay.x() * onSurface.x() + onRay.z() * onSurface.z(), 0) << "Is the angle on the right side?";
        }
    }
}

}  // namespace
}  // namespace caustic
