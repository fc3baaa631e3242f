#pragma once

#include <cstdint>
#include <functional>

#include "core/random.h"
#include "math/transform.h"
#include "shape/shape.h"

namespace caustic {

/// A way to leave a surface: the new ray from a hit, in a direction of either side.
using LeavingRule = std::function<Ray(const Hit& from, const Vec3& direction)>;

/// The course's rule (spawnRay).
LeavingRule relativeRule();

/// What most first ray tracers do: the same distance everywhere, along the normal to the side of the direction.
LeavingRule fixedRule(Real distance);

/// How many of so many cases went wrong.
struct FailureCount {
    std::int64_t failures = 0;
    std::int64_t trials = 0;

    /// Adds the other's cases.
    FailureCount& operator+=(const FailureCount& other);
};

/// Rays that hit `shape` from random places around, leave it from there in random directions to either side, and meet
/// it where they must not.
///
/// A hit is wrong when the side that it is hit from contradicts the side that the ray left to: a ray that left
/// outwards can only enter, one that went inwards can only come out, and must, from a closed shape. From a convex shape
/// nothing that leaves outwards comes back. Directions go down to 1e-8 from the tangent plane.
/// @param center, reach  rays start at three times that distance and aim at the shape, or into that ball if the shape
///                       can't be sampled
FailureCount countSelfHits(const Shape& shape, bool closed, bool convex, const LeavingRule& rule, const Vec3& center,
                           Real reach, std::int64_t rays, std::uint64_t seed);

/// Two things of a size, `gap` apart: rays leave each towards the other and must not miss it. The upper one is a
/// sphere, a box, a ring cylinder or a turned box, in turn.
/// @param place  takes the pair, of size 1 around the origin, to where and how large it shall be; no rotation
FailureCount countLostContacts(const Transform& place, Real gap, const LeavingRule& rule, std::int64_t rays,
                               std::uint64_t seed);

/// Rays that enter a plate through its face and must meet the far side, `thickness` away.
FailureCount countLostFarSides(const Transform& place, Real thickness, const LeavingRule& rule, std::int64_t rays,
                               std::uint64_t seed);

/// A unit vector to one side of the plane with unit normal n; the angle to the plane is small more often than not, down
/// to 1e-8.
Vec3 directionBeside(const Vec3& n, bool outwards, Random& random);

/// A unit vector, all directions alike.
Vec3 randomDirection(Random& random);

/// A point of the ball around the origin with radius 1.
Vec3 randomInBall(Random& random);

}  // namespace caustic
