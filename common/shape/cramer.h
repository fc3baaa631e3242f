#pragma once

#include <optional>

#include "math/ray.h"
#include "shape/triangle_hit.h"

namespace caustic {

/// Ray and triangle as the report does it: origin + t · direction = (1 - b1 - b2) · a + b1 · b + b2 · c is three linear
/// equations in t, b1 and b2, solved by Cramer's rule. Also known as Möller and Trumbore's test (1997).
///
/// Fast, short, and not watertight: two triangles round the same edge in different ways, and a ray may slip through
/// between them. Scenes use intersectWatertight.
///
/// Both sides of the triangle count, and its edges belong to it. No triangle is too small: a ray is in its plane, or it
/// has no area, only if the equations' determinant is 0.
/// @return nothing for a miss, a t that the ray doesn't reach, a ray in the triangle's plane, or a triangle without
///         area
std::optional<TriangleHit> intersectCramer(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace caustic
