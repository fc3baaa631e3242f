#pragma once

#include "math/bounds.h"
#include "math/interval.h"
#include "math/ray.h"

namespace caustic {

/// The t between tMin and tMax, both included, at which a ray is in a closed box; an empty interval when it never
/// is. No t is infinite: with tMax = ∞ the interval ends at the largest finite number at the latest, so that a ray
/// which runs beside the box is in it nowhere.
///
/// Right for every direction, components 0 and -0 included, wherever the origin is: in a face, an edge or a corner too,
/// where 0 · ∞ lurks. A ray within a face is in the box. The box may be flat or infinite.
/// Source: Kay & Kajiya 1986; NaN by the order of comparisons as in Barnes 2022, Fast, Branchless Ray/Bounding Box
/// Intersections, Part 3. Tests: tests/02_intersections/stability_slabs.cpp.
Interval slabInterval(const Bounds3& box, const Ray& ray);

/// Whether the ray may meet what the box bounds: never false when it does, rounding included.
///
/// The far end is moved out by the bound on its rounding error, 2γ(3): Ize 2013, Robust BVH Ray Traversal, JCGT 2(2).
bool mayMeet(const Bounds3& box, const Ray& ray);

}  // namespace caustic
