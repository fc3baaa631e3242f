#pragma once

#include <array>
#include <cstddef>

#include "math/interval.h"
#include "math/vector.h"

namespace caustic {

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

/// The part of [0, 1]² that can hold zeros of a net; an interval is empty when there are none. Within [0, 1]² it is
/// enlarged by what `tolerance` in both coordinates can move a zero: u at each end by tolerance · (|b.x| + |b.y|) /
/// |a × b|, v likewise with a; by four times as much at most. All of [0, 1]² when the mean derivatives a and b are
/// too close to parallel to tell, |a × b| <= 1e-6 |a| |b|. The sign of a × b means nothing.
///
/// With a and b the mean derivatives by u and v, the inverse of the matrix (a b) turns the net into one close to the
/// identity: q(u, v) = (u, v) + r(u, v). A Bernstein polynomial with the control values i/m is u itself (linear
/// precision), so the control points of r are those of q less (i/m, j/n), and r lies in their box. At a zero (u, v) =
/// -r(u, v). What is left shrinks with the square of what there was.
/// @param tolerance  how far from zero a value may be and count as zero, in the net's unit
PatchDomain clippedDomain(const PlaneNet& net, Real tolerance);

/// Whether the map can take no value twice: every derivative by u, made comparable by the mean ones, turns every
/// derivative by v the same way.
bool isOneToOne(const PlaneNet& net);

/// The net over the halves of its domain in u, by de Casteljau's algorithm at 1/2.
void halveU(const PlaneNet& net, PlaneNet& first, PlaneNet& second);
/// The same in v.
void halveV(const PlaneNet& net, PlaneNet& first, PlaneNet& second);

/// The z component of the cross product.
inline Real crossOf(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace caustic
