#include <gtest/gtest.h>

#include <limits>

#include "failures/slab_cases.h"
#include "leaving.h"
#include "math/slabs.h"
#include "shape/box.h"

namespace caustic {
namespace {

// 20 boxes × 56 directions × 125 origins; the truth is found by cases, without a division by zero.
TEST(Slabs, RightForEveryPatternOfZeroComponentsAndEveryPlaceOfTheOrigin) {
    const std::vector<SlabCase> cases = slabCases(20, 1);
    ASSERT_EQ(cases.size(), 20U * 56 * 125);
    for (const SlabCase& one : cases) {
        const Interval found = slabInterval(one.box, one.ray);
        ASSERT_FALSE(std::isnan(found.lower) || std::isnan(found.upper)) << "0 · ∞ from an origin " << one.origin;
        ASSERT_EQ(found.empty(), !one.meets) << "origin " << one.ray.origin.transpose() << " (" << one.origin
                                             << "), direction " << one.ray.direction.transpose() << ", box "
                                             << one.box.min().transpose() << " to " << one.box.max().transpose();
        if (!one.meets) continue;
        EXPECT_EQ(found.lower, one.truth.lower);
        EXPECT_EQ(found.upper, one.truth.upper);
        EXPECT_TRUE(mayMeet(one.box, one.ray));
    }
}

// The box as a shape on the same cases: a hit is the first end of the interval that lies ahead of the ray, on the box,
// with a normal of one of the axes.
TEST(Slabs, BoxIsHitWhereTheIntervalEnds) {
    for (const SlabCase& one : slabCases(5, 2)) {
        const Box box(one.box.min(), one.box.max());
        const auto hit = box.intersect(one.ray);
        const bool ahead = one.meets && one.truth.upper > 0 && one.truth.upper < std::numeric_limits<Real>::max();
        ASSERT_EQ(hit.has_value(), ahead) << one.ray.origin.transpose() << " -> " << one.ray.direction.transpose();
        if (!hit) continue;
        EXPECT_EQ(hit->t, one.truth.lower > 0 ? one.truth.lower : one.truth.upper);
        EXPECT_EQ(hit->point, one.ray.at(hit->t));
        EXPECT_EQ(hit->ng.cwiseAbs().sum(), 1);
        int axis = 0;
        hit->ng.cwiseAbs().maxCoeff(&axis);
        EXPECT_EQ(hit->point[axis], hit->ng[axis] > 0 ? one.box.max()[axis] : one.box.min()[axis]);
    }
}

TEST(Slabs, NaiveTestIsWrongWhereZeroMeetsInfinity) {
    int wrong = 0;
    for (const SlabCase& one : slabCases(1, 1)) wrong += meetsNaively(one.box, one.ray) != one.meets ? 1 : 0;
    EXPECT_GT(wrong, 100);
}

// The smallest numbers' reciprocals are infinite, the largest ones' products overflow.
TEST(Slabs, TinyAndHugeComponentsBehaveLikeTheirLimits) {
    const Bounds3 box(Vec3::Constant(-1), Vec3::Constant(1));
    const Real tiny = std::numeric_limits<Real>::denorm_min();
    for (const Real x : {tiny, -tiny, 1e-300, -1e-300}) {
        EXPECT_FALSE(slabInterval(box, {Vec3(0.5, 0, -3), Vec3(x, 0, 1)}).empty());
        EXPECT_FALSE(slabInterval(box, {Vec3(std::copysign(1, -x), 0, -3), Vec3(x, 0, 1)}).empty()) << "from a face";
        EXPECT_TRUE(slabInterval(box, {Vec3(1.5, 0, -3), Vec3(x, 0, 1)}).empty());
    }
    EXPECT_FALSE(slabInterval(box, {Vec3(0, 0, -1e300), Vec3(0, 0, 1e300)}).empty());
}

TEST(Slabs, FlatAndInfiniteBoxesAreMet) {
    const Real infinity = std::numeric_limits<Real>::infinity();
    const Bounds3 flat(Vec3(-1, 2, -1), Vec3(1, 2, 1));
    EXPECT_FALSE(slabInterval(flat, {Vec3(0, 0, 0), Vec3(0.1, 1, 0.1)}).empty());
    EXPECT_FALSE(slabInterval(flat, {Vec3(-3, 2, 0), Vec3(1, 0, 0)}).empty()) << "A ray in the flat box is in it.";
    EXPECT_TRUE(slabInterval(flat, {Vec3(-3, 2.5, 0), Vec3(1, 0, 0)}).empty());
    const Bounds3 everything(Vec3::Constant(-infinity), Vec3::Constant(infinity));
    for (const Real x : {0.0, -0.0, 1.0, -1.0}) {
        EXPECT_FALSE(slabInterval(everything, {Vec3(7, 8, 9), Vec3(x, -0.0, 1)}).empty());
    }
}

// What a box bounds is never lost to rounding: triangles' corners are corners of their boxes.
TEST(Slabs, MayMeetNeverMissesAPointOfTheBox) {
    for (int i = 0; i < 200000; ++i) {
        Random random(3, {static_cast<std::uint64_t>(i)});
        const Vec3 low = 100 * randomInBall(random);
        const Vec3 high = low + randomDirection(random).cwiseAbs();
        const Bounds3 box(low, high);
        // A corner, or a point of an edge, from far away.
        Vec3 target = box.corner(static_cast<Bounds3::CornerType>(random.below(8)));
        if (random.below(2) == 0) target.x() = random.uniform(low.x(), high.x());
        const Vec3 origin = 1000 * randomInBall(random);
        const Ray ray = {origin, target - origin};
        // The rounded ray passes beside the target by a rounding of the subtraction; so does the box's own ray through
        // its corner. Only rays that aim at the box's inside are certain to meet it.
        const Vec3 inside = target + 1e-12 * (box.center() - target);
        EXPECT_TRUE(mayMeet(box, {origin, inside - origin})) << ray.direction.transpose();
    }
}

}  // namespace
}  // namespace caustic
