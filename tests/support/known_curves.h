#pragma once

#include "curve/bezier_curve.h"

namespace caustic::test {

/// B(t) = (t, t², 0).
BezierCurve parabola();

/// Its arc length from 0 to t: (2t sqrt(1 + 4t²) + asinh(2t)) / 4.
Real parabolaLength(Real t);

/// B(t) = ((t-c)², (t-c)³, 0): the semicubical parabola with its cusp at t = c.
BezierCurve semicubicalParabola(Real c);

/// Its arc length from 0 to t: with F(s) = ((4 + 9s²)^(3/2) - 8) / 27 it is F(c) ± F(t-c), + beyond the cusp.
Real semicubicalParabolaLength(Real c, Real t);

/// Each coordinate is w(t) = 9 t (1-t) (1-2t) or a multiple of it with an offset: w, 1 - w, 5 + 2w. So both extrema of
/// each lie inside, at t = 1/2 ± sqrt(3)/6, where w = ∓ sqrt(3)/2.
BezierCurve wave();

/// y = -∫ (s + w) s (s - 1.3 w) ds, s = t - a; x = t. Two maxima, at t = a - w and, the higher one, at a + 1.3 w.
BezierCurve twoHumps(Real a, Real w);

}  // namespace caustic::test
