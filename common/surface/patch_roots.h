#pragma once

#include <vector>

#include "curve/bezier_patch.h"
#include "math/interval.h"
#include "shape/watertight.h"

namespace caustic {

/// Where a line meets a patch.
struct PatchRoot {
    Real u;
    Real v;
    Real t;  ///< in lengths of the ray's direction
};

/// A patch as a ray sees it that runs along the z axis: a map from (u, v) to the plane, whose zeros are the meetings.
/// Control points P_ij at [i][j].
struct PlaneNet {
    /// Of a patch in each direction; more is refused.
    static constexpr int highestDegree = 9;

    int degreeU;                                                               ///< in u, at least 1
    int degreeV;                                                               ///< in v, at least 1
    std::array<std::array<Vec2, highestDegree + 1>, highestDegree + 1> point;  ///< the control points
};

/// A part of a patch's domain.
struct PatchDomain {
    Interval u = {0, 1};
    Interval v = {0, 1};
};

/// The part of [0, 1]² that can hold zeros of a net, a little enlarged by `tolerance`; an interval is empty when there
/// are none. All of [0, 1]² when the net is too far from a linear map to tell.
///
/// With a and b the mean derivatives by u and v, the inverse of the matrix (a b) turns the net into one close to the
/// identity: q(u, v) = (u, v) + r(u, v). A Bernstein polynomial with the control values i/m is u itself (linear
/// precision), so the control points of r are those of q less (i/m, j/n), and r lies in their box. At a zero (u, v) =
/// -r(u, v). What is left shrinks with the square of what there was.
/// @param tolerance  how far from zero a value may be and count as zero, in the net's unit
PatchDomain clippedDomain(const PlaneNet& net, Real tolerance);

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
