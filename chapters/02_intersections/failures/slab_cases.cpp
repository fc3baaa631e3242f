#include "failures/slab_cases.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/random.h"

namespace caustic {

namespace {

// The truth on one axis by cases, without a division by zero; empty if the ray never is between the planes.
Interval slabTruth(Real low, Real high, Real origin, Real direction) {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    if (direction == 0) {
        const bool between = low <= origin && origin <= high;
        return between ? Interval{-infinity, infinity} : Interval{infinity, -infinity};
    }
    const Real first = (low - origin) / direction;
    const Real second = (high - origin) / direction;
    return {std::min(first, second), std::max(first, second)};
}

SlabCase makeCase(const Bounds3& box, const Vec3& origin, const Vec3& direction) {
    SlabCase made = {"", box, {origin, direction}, false, {0, std::numeric_limits<Real>::max()}};
    int planes = 0;
    bool outside = false;
    for (int axis = 0; axis < 3; ++axis) {
        const Real low = box.min()[axis];
        const Real high = box.max()[axis];
        const Interval slab = slabTruth(low, high, origin[axis], direction[axis]);
        made.truth = {std::max(made.truth.lower, slab.lower), std::min(made.truth.upper, slab.upper)};
        planes += origin[axis] == low || origin[axis] == high ? 1 : 0;
        outside = outside || origin[axis] < low || origin[axis] > high;
    }
    const char* const names[] = {"inside", "a face", "an edge", "a corner"};
    made.origin = outside ? "outside" : names[planes];
    made.meets = !made.truth.empty();
    return made;
}

}  // namespace

std::vector<SlabCase> slabCases(int boxes, std::uint64_t seed) {
    constexpr Real components[] = {1, -1, 0.0, -0.0};
    std::vector<SlabCase> cases;
    for (int i = 0; i < boxes; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        Vec3 low;
        Vec3 high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = static_cast<Real>(random.below(9)) - 4;
            high[axis] = low[axis] + 2 + static_cast<Real>(random.below(4));
        }
        for (int code = 0; code < 125 * 64; ++code) {
            const int place[] = {code % 5, code / 5 % 5, code / 25 % 5};
            const int way[] = {code / 125 % 4, code / 500 % 4, code / 2000};
            Vec3 origin;
            Vec3 direction;
            for (int axis = 0; axis < 3; ++axis) {
                const Real places[] = {low[axis] - 1, low[axis], low[axis] + 1, high[axis], high[axis] + 1};
                origin[axis] = places[place[axis]];
                direction[axis] = components[way[axis]];
            }
            if (!direction.isZero(0)) cases.push_back(makeCase({low, high}, origin, direction));
        }
    }
    return cases;
}

bool meetsNaively(const Bounds3& box, const Ray& ray) {
    Real lower = ray.tMin;
    Real upper = ray.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const Real inverse = 1 / ray.direction[axis];
        Real t0 = (box.min()[axis] - ray.origin[axis]) * inverse;
        Real t1 = (box.max()[axis] - ray.origin[axis]) * inverse;
        if (inverse < 0) std::swap(t0, t1);
        lower = std::max(t0, lower);
        upper = std::min(t1, upper);
        if (upper < lower) return false;
    }
    return lower <= upper;
}

}  // namespace caustic
