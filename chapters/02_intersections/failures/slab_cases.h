#pragma once

#include <string>
#include <vector>

#include "math/bounds.h"
#include "math/interval.h"
#include "math/ray.h"

namespace caustic {

/// A ray and a box with what is true of them.
struct SlabCase {
    std::string origin;  ///< where the ray starts: "outside", "inside", "a face", "an edge", "a corner"
    Bounds3 box;
    Ray ray;
    bool meets;      ///< whether some point of the ray is in the closed box
    Interval truth;  ///< for which t, if so
};

/// Every combination of 1, -1, 0 and -0 as components of the direction (but for no direction at all) with origins
/// before, on, between, on and beyond the two planes of each slab: 56 × 125 cases a box. `boxes` boxes with corners at
/// small integers, so that every t is exact.
std::vector<SlabCase> slabCases(int boxes, std::uint64_t seed);

/// The slab test as it is often written: swap when the direction is negative, compare, hope that 0 · ∞ does no harm.
bool meetsNaively(const Bounds3& box, const Ray& ray);

}  // namespace caustic
