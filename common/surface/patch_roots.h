#pragma once

#include <vector>

#include "curve/bezier_patch.h"
#include "shape/watertight.h"
#include "surface/plane_net.h"

namespace caustic {

/// Where a line meets a patch.
struct PatchRoot {
    Real u;
    Real v;
    Real t;  ///< in lengths of the ray's direction
};

/// All meetings of a ray's line with a patch. None is missed: the domain is cut down by clippedDomain and by halving
/// until each part is free of zeros or certain to hold at most one, which Newton's method then finds. The tolerance is
/// some 64 units of rounding of the distances involved, so rays at an edge that two patches share meet at least one.
/// Where the line touches the patch, or runs in it, at least one root in each connected place whose residual is within
/// the tolerance is reported, or none.
/// Source: after Nishita, Sederberg, Kakimoto 1990, Ray Tracing Trimmed Rational Surface Patches; the box of the
/// residual in place of their hulls is Moore's and Jones' 1977 test for the Bernstein basis.
/// @param patch  degrees up to PlaneNet::highestDegree
std::vector<PatchRoot> patchRoots(const BezierPatch& patch, const ShearedRay& sheared);

}  // namespace caustic
