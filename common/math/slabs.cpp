#include "math/slabs.h"

#include <algorithm>
#include <limits>

#include "core/not_implemented.h"

namespace caustic {

Interval slabInterval(const Bounds3& box, const Ray& ray) {
    //! [ex-02.1]
    // No t is infinite: a ray that runs beside a slab, where both planes are infinitely far, must not be "in" it there.
    Interval inside = {ray.tMin, std::min(ray.tMax, std::numeric_limits<Real>::max())};
    for (int axis = 0; axis < 3; ++axis) {
        const Real inverse = 1 / ray.direction[axis];
        const Real t0 = (box.min()[axis] - ray.origin[axis]) * inverse;
        const Real t1 = (box.max()[axis] - ray.origin[axis]) * inverse;
        // 0 · ∞ happens when the ray runs within one of the planes: NaN, which must not restrict anything. std::max
        // and std::min return their first argument then.
        const Real lower = std::min(std::max(inside.lower, t0), std::max(inside.lower, t1));
        inside.upper = std::max(std::min(inside.upper, t0), std::min(inside.upper, t1));
        inside.lower = lower;
    }
    return inside;
    //! [ex-02.1]
}

bool mayMeet(const Bounds3& box, const Ray& ray) {
    constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
    constexpr Real gamma3 = 3 * unitRoundoff / (1 - 3 * unitRoundoff);
    const Interval inside = slabInterval(box, ray);
    return inside.lower <= inside.upper * (1 + 2 * gamma3);
}

}  // namespace caustic
