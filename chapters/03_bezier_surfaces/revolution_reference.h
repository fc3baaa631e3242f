#pragma once

#include <vector>

#include "curve/bezier_curve.h"
#include "math/ray.h"

namespace caustic {

/// A place where a line meets a surface, as brute force sees it: an interval of t that is too short to matter.
struct ReferenceMeeting {
    Real tLow;
    Real tHigh;

    /// Whether nobody can tell how often the line meets the surface there: it runs within `tangencyBand` of a tangent,
    /// through an open edge, a cusp, a cone's tip, or a corner of the profile that it touches from one side.
    bool inBand;
};

/// Meetings that a search came upon in any order and in pieces, in the order of t; those within `gap` are one.
std::vector<ReferenceMeeting> merged(std::vector<ReferenceMeeting> found, Real gap);

/// Cosine between ray and normal below which a meeting counts as tangent.
inline constexpr Real tangencyBand = 1e-5;

/// All meetings of a ray's line with a profile turned around the y axis, by brute force, in the order of t.
///
/// Shares no code with the library: 64-bit mantissas, its own de Casteljau, and no equation at all. A piece of the
/// profile lies in a ring (by its control points); where the line is in that ring is a matter of two planes and two
/// cylinders; pieces whose ring the line misses are dropped, others halved, down to a width of 2^-46. What is left is a
/// meeting.
std::vector<ReferenceMeeting> meetingsBySubdivision(const std::vector<BezierCurve>& profile, const Ray& ray);

/// How far the point at t is from the circle that the profile's point at u makes, in 64-bit mantissas.
Real distanceFromRevolved(const BezierCurve& segment, Real u, const Vec3& point);

}  // namespace caustic
