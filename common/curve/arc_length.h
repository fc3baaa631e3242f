#pragma once

#include <vector>

#include "curve/bezier_curve.h"

namespace caustic {

/// Length of the polygon through the points at t = 0, 1/segments, 2/segments ... 1: never longer than the curve
/// (rounding aside); where the curve is smooth the error falls with segments². Right for curves so large or so small
/// that squares of their coordinates are not: stableNorm.
/// @param segments  at least 1
/// @throws InputError when segments < 1
Real chordLength(const BezierCurve& curve, int segments);

/// A length and what is known of it.
struct LengthEstimate {
    Real length;      ///< in the control points' unit
    Real error;       ///< the true length lies within length ± error; rounding is included
    int evaluations;  ///< how often the curve's derivative was evaluated
};

/// Length of the curve between two parameters by adaptive Gauss–Legendre quadrature of |B'(t)|.
///
/// The error is a proven bound, not a guess: cusps, loops and zero length included. It is at most `tolerance`, unless
/// rounding forbids that (the bound tells); the search ends all the same, after some thousand pieces at most. A
/// generous tolerance takes few evaluations. 0 when from = to. Right for curves of any size.
/// @param tolerance  largest error wanted, in the control points' unit; greater than 0
/// @param from,to    0 <= from <= to <= 1
/// @throws InputError when tolerance, from or to is out of its domain
LengthEstimate gaussLength(const BezierCurve& curve, Real tolerance, Real from = 0, Real to = 1);

/// The count + 1 parameters, in increasing order from 0 to 1, that cut the curve into `count` pieces of equal length.
///
/// Pieces' lengths agree to 1e-9 of the curve's length, whatever its size, cusps included. For a curve of zero length
/// the parameters are evenly spaced.
/// @param count  pieces wanted, at least 1
/// @throws InputError when count < 1
std::vector<Real> evenlySpaced(const BezierCurve& curve, int count);

}  // namespace caustic
