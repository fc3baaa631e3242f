#pragma once

#include <limits>

#include "math/vector.h"

namespace caustic {

/// A half-line, or a piece of one: the points origin + t · direction with tMin < t < tMax.
///
/// The direction need not be of unit length: t counts in lengths of `direction`. That is what lets a ray go through a
/// Transform with its t unchanged, and what makes t = 1 the far end of a shadow ray. It must be finite and not zero,
/// and its squared length must neither overflow nor underflow. Shapes report no hit for a ray with a NaN in it.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
    Real tMin = 0;
    Real tMax = std::numeric_limits<Real>::infinity();

    /// The point at t, whether the ray reaches it or not.
    Vec3 at(Real t) const { return origin + t * direction; }

    /// Whether a hit at t counts. Both ends are left out, and NaN is out too.
    bool reaches(Real t) const { return t > tMin && t < tMax; }
};

}  // namespace caustic
