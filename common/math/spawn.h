#pragma once

#include "math/ray.h"
#include "math/surface_point.h"

namespace caustic {

/// How far a ray starts from the surface that it leaves, in magnitudes of the point: 1024 machine epsilons. The shapes
/// of chapter 02 need 2 at most (its quantity.csv); the rest is for surfaces that a point is found on by iteration.
inline constexpr Real surfaceOffset = 0x1p-42;

/// The one rule for leaving a surface: the point, moved along ng to the side that `direction` goes to, by surfaceOffset
/// times the magnitude. A tangent direction counts as outside.
/// @param direction  of any length
/// @param magnitude  in proportion to which the point is moved; at least the point's own
Vec3 offsetPoint(const SurfacePoint& from, const Vec3& direction, Real magnitude);

/// A ray that leaves the surface in a direction (of any length, to either side) and does not meet it where it started.
Ray spawnRay(const SurfacePoint& from, const Vec3& direction);

/// A ray from the surface to a point in free space, which it reaches at tMax = 1.
Ray spawnRayTo(const SurfacePoint& from, const Vec3& to);

/// A ray between two surfaces that meets neither of the two where it starts and ends; tMax = 1.
Ray spawnRayTo(const SurfacePoint& from, const SurfacePoint& to);

}  // namespace caustic
