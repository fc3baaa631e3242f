#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/slabs.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// How far the point at t is from the nearest of the six planes.
Real fromAFace(const Bounds3& box, const Ray& ray, Real t) {
    const Vec3 low = (ray.at(t) - box.min()).cwiseAbs();
    const Vec3 high = (ray.at(t) - box.max()).cwiseAbs();
    return std::min(low.minCoeff(), high.minCoeff());
}

// By definition: t belongs to the interval when the point at t is in the box. Where a ray's coordinate is low or high
// is found one t at a time, on a grid that no box here is tuned to. The ends themselves lie on the box, or are the
// ray's.
TEST(Slabs, IntervalIsWhereTheRayIsInTheBox) {
    for (const Real size : {1e-6, 1.0, 1e6}) {
        for (std::uint64_t i = 0; i < 1000; ++i) {
            Random random(1, {i});
            const Vec3 corner = 2 * inCube(random);
            const Bounds3 box(size * corner, size * (corner + Vec3::Constant(0.5) + inCube(random).cwiseAbs()));
            Ray ray = {4 * size * inCube(random), 0.3 * size * inCube(random), random.uniform(-20, 20), infinity};
            if (random.below(2) == 0) ray.tMax = ray.tMin + random.uniform(0, 20);
            const Interval found = slabInterval(box, ray);
            for (Real t = -40.05; t < 40; t += 0.1) {
                const bool inRange = t >= ray.tMin && t <= ray.tMax;
                const bool inBox = box.contains(ray.at(t));
                ASSERT_EQ(found.lower <= t && t <= found.upper, inRange && inBox)
                    << "At t = " << t << ", size " << size
                    << ": does the interval start from tMin and tMax, and does each slab only narrow it?";
            }
            if (found.empty()) continue;
            for (const auto& [end, own] : {std::pair(found.lower, ray.tMin), {found.upper, ray.tMax}}) {
                ASSERT_TRUE(end == own || fromAFace(box, ray, end) <= 1e-13 * size * (1 + std::abs(end)))
                    << "t = " << end << " lies on no face: is it computed as precisely as the box is known?";
            }
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
    const Bounds3 flat(Vec3(-1, 3, -3), Vec3(1, 3, -1));
    for (const Real zero : {0.0, -0.0}) {
        const Interval within = slabInterval(flat, {Vec3(-5, 3, -2), Vec3(1, zero, zero)});
        EXPECT_EQ(within.lower, 4) << "A flat box, and a ray in its plane: both planes are one.";
        EXPECT_EQ(within.upper, 6);
    }
}

// A box that is a wall or a slab of infinite extent, and one without thickness: a ray beside it is never in it,
// although it crosses the planes "at" infinity; one between the planes always is.
TEST(Slabs, InfiniteAndFlatBoxesHoldWhatIsBetweenTheirPlanes) {
    for (const Real zero : {0.0, -0.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const Real thickness : {0.0, 2.0}) {
                Vec3 low = Vec3::Constant(-infinity);
                Vec3 high = Vec3::Constant(infinity);
                low[axis] = 3;
                high[axis] = 3 + thickness;
                const Bounds3 slab(low, high);
                Vec3 direction(0.5, -2, 1);
                direction[axis] = zero;
                for (const Real height : {2.0, 4.0, 6.0}) {
                    Vec3 origin(1, -1, 2);
                    origin[axis] = height;
                    const bool within = height <= 3 + thickness && height >= 3;
                    EXPECT_EQ(!slabInterval(slab, {origin, direction}).empty(), within)
                        << "height " << height << " over a slab from 3 to " << 3 + thickness
                        << ": is a ray beside it in it at t = ∞?";
                    const Interval piece = slabInterval(slab, {origin, direction, 1, 4});
                    EXPECT_EQ(!piece.empty(), within);
                    if (within) {
                        EXPECT_EQ(piece.lower, 1) << "Nothing but the ray's ends bounds it.";
                        EXPECT_EQ(piece.upper, 4);
                    }
                }
                const Ray through = {-2 * Vec3::Unit(axis), Vec3::Unit(axis)};
                EXPECT_EQ(slabInterval(slab, through).lower, 5) << "A flat box is met at one t.";
                EXPECT_EQ(slabInterval(slab, through).upper, 5 + thickness);
            }
        }
    }
}

}  // namespace
}  // namespace caustic
