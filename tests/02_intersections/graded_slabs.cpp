#include <gtest/gtest.h>

#include <limits>

#include "math/slabs.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// By definition: t belongs to the interval when the point at t is in the box. Where a ray's coordinate is low or high
// is found one t at a time, on a grid that no box here is tuned to.
TEST(Slabs, IntervalIsWhereTheRayIsInTheBox) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(1, {i});
        const Vec3 corner = 2 * inCube(random);
        const Bounds3 box(corner, corner + Vec3::Constant(0.5) + inCube(random).cwiseAbs());
        Ray ray = {4 * inCube(random), 0.3 * inCube(random), random.uniform(-20, 20), infinity};
        if (random.below(2) == 0) ray.tMax = ray.tMin + random.uniform(0, 20);
        const Interval found = slabInterval(box, ray);
        for (Real t = -40.05; t < 40; t += 0.1) {
            const bool inRange = t >= ray.tMin && t <= ray.tMax;
            const bool inBox = box.contains(ray.at(t));
            ASSERT_EQ(found.lower <= t && t <= found.upper, inRange && inBox)
                << "At t = " << t << ": does the interval start from tMin and tMax, and does each slab only narrow it?";
        }
    }
}

// A ray that runs along an axis: inside the closed box for every t of the other slabs when its origin is between the
// planes or in one of them, never otherwise. 0 · ∞ is NaN, and NaN must not decide.
TEST(Slabs, ZeroComponentsAreRightInFacesEdgesAndCorners) {
    const Bounds3 box(Vec3(-1, 2, -3), Vec3(1, 4, -1));
    for (const Real zero : {0.0, -0.0}) {
        for (const Real sign : {1.0, -1.0}) {
            for (int along = 0; along < 3; ++along) {
                for (int place = 0; place < 25; ++place) {
                    const int places[] = {place % 5, place / 5};
                    Vec3 origin = box.center();
                    Vec3 direction = Vec3::Constant(zero);
                    origin[along] = box.center()[along] - 5 * sign;
                    direction[along] = sign;
                    bool meets = true;
                    for (int other = 0; other < 2; ++other) {
                        const int axis = (along + 1 + other) % 3;
                        const Real low = box.min()[axis];
                        const Real candidates[] = {low - 1, low, low + 1, low + 2, low + 3};
                        origin[axis] = candidates[places[other]];
                        meets = meets && places[other] >= 1 && places[other] <= 3;
                    }
                    const Interval found = slabInterval(box, {origin, direction});
                    ASSERT_EQ(!found.empty(), meets)
                        << "origin " << origin.transpose() << ", direction " << direction.transpose()
                        << ": which of its two arguments does std::max return when one is NaN?";
                    if (!meets) continue;
                    EXPECT_EQ(found.lower, 4) << "origin " << origin.transpose();
                    EXPECT_EQ(found.upper, 6) << "origin " << origin.transpose();
                }
            }
        }
    }
}

}  // namespace
}  // namespace caustic
