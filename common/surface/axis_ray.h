#pragma once

#include "math/ray.h"

namespace caustic {

/// A ray's line as a surface of revolution around the y axis sees it: by height and by distance from the axis.
///
/// With s measured in lengths of space from a base point, the line's height is baseHeight + rise · s, and the square of
/// its distance from the axis is flat² s² + 2 drift s + near². Turning the line around the axis makes a hyperboloid of
/// one sheet; where the profile meets that hyperboloid, the line meets the surface. So a problem in space becomes one
/// in the plane of the profile.
///
/// The base is chosen so that no large numbers cancel: for a line that leans towards the plane of rotation it is the
/// point nearest to the axis, where drift is 0; for one that leans towards the axis, the point at the height `middle`.
struct AxisRay {
    /// @param middle  height about which the surface lies
    AxisRay(const Ray& ray, Real middle);

    /// The ray's own parameter of the point at s.
    Real tAt(Real s) const { return tBase + s * tPerLength; }

    /// x and z of the point at s: a vector of the plane of rotation.
    Vec2 acrossAt(Real s) const { return base + s * across; }

    Vec2 base;        ///< x and z of the base point
    Vec2 across;      ///< x and z of the unit direction
    Real baseHeight;  ///< y of the base point
    Real rise;        ///< cosine of the angle to the axis
    Real perRise;     ///< 1 / rise: s for one of height; infinite in the plane of rotation
    Real flat;        ///< sine of the angle to the axis, not negative
    Real flatSquare;  ///< flat², to full precision: 1 - rise² has few digits for a line along the axis
    Real drift;       ///< base · across, half the slope of the squared distance there; 0 when leaning
    Real near;        ///< distance of the base point from the axis
    Real nearest;     ///< s of the point nearest to the axis
    bool leaning;     ///< closer to the plane of rotation than to the axis
    Real tBase;       ///< the ray's own parameter of the base point
    Real tPerLength;  ///< 1 / length of the ray's direction
};

}  // namespace caustic
