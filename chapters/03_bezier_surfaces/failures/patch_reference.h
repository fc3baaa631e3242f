#pragma once

#include <vector>

#include "curve/bezier_patch.h"
#include "revolution_reference.h"

namespace caustic {

/// All meetings of a ray's line with a patch, by brute force, in the order of t.
///
/// Shares no code with the library: 64-bit mantissas, its own halving, axis-aligned boxes of the control points in
/// space, down to a width of 2^-38; a meeting is as long as such a box seen along the line. In the band are lines
/// within tangencyBand of a tangent, through the patch's border, or through a place where its derivatives vanish.
std::vector<ReferenceMeeting> meetingsBySubdivision(const BezierPatch& patch, const Ray& ray);

/// How far the point is from B(u, v), in 64-bit mantissas.
Real distanceFromPatch(const BezierPatch& patch, Real u, Real v, const Vec3& point);

}  // namespace caustic
