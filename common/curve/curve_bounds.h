#pragma once

#include "curve/bezier_curve.h"
#include "math/bounds.h"

namespace caustic {

/// Bounding box of the curve on [0, 1] the report's way: for each axis evenly spaced samples, brackets where the
/// samples turn (and at both ends), and a ternary search for the extremum inside each bracket, until rounding ends it.
/// For a maximum, a bracket reaches from the sample before to the sample after one that is not lower than either; equal
/// neighbours count, and a sample at an end has one neighbour only.
///
/// Never larger than the true box but for rounding. It can be too small: a pair of extrema between two neighbouring
/// samples goes unseen. exactBounds() misses nothing.
/// @param samples  number of sample points, the two end points among them; at least 2
/// @throws InputError when samples < 2
Bounds3 sampledBounds(const BezierCurve& curve, int samples);

/// Bounding box of the curve on [0, 1] from the roots of each coordinate's derivative in Bernstein form.
///
/// Contains the exact curve, and every point that position(t) computes for t in [0, 1]: never smaller than the curve.
/// On each side it exceeds the true box by at most 16 (n + 1) u × the largest control coordinate of that axis, u =
/// 2^-53.
Bounds3 exactBounds(const BezierCurve& curve);

}  // namespace caustic
