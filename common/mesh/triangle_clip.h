#pragma once

#include "math/bounds.h"
#include "math/vector.h"

namespace caustic {

/// The smallest box, but for rounding, around the part of a triangle that is inside of another, closed box; empty
/// (default-constructed) when no part is. Never larger than either.
///
/// A tree that files a triangle by this box instead of its own visits it in fewer cells.
/// Source: Sutherland, Hodgman 1974, Reentrant Polygon Clipping; in trees Havran 2000, "split clipping".
/// @param inside  neither empty nor NaN
Bounds3 clippedTriangleBounds(const Vec3& a, const Vec3& b, const Vec3& c, const Bounds3& inside);

}  // namespace caustic
