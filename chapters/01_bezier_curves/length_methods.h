#pragma once

#include "curve/bezier_curve.h"
#include "curve/gauss_legendre.h"

namespace caustic {

/// Length by one Gauss–Legendre rule over the whole curve: no splitting and no idea of the error. What adaptive
/// quadrature is compared with.
Real plainGaussLength(const BezierCurve& curve, const GaussRule& rule);

/// The cubic (u², u³) for u = t - cusp, turned by an angle and scaled: it stops and turns back at t = cusp.
/// @param cusp  in (0, 1)
/// @param size  scale, greater than 0; with a multiple of 3, a cusp of few bits and no turn the control points are
/// exact
BezierCurve cuspidalCubic(Real cusp, Real size, Real angle);

/// Its length, by the closed form of the integral of u √(4 + 9 u²), on both sides of the cusp.
Real cuspidalCubicLength(Real cusp, Real size);

}  // namespace caustic
