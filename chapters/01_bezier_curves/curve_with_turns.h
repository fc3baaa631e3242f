#pragma once

#include <vector>

#include "curve/bezier_curve.h"

namespace caustic {

/// A plane curve that rises steadily, y = t, while its x turns back at given parameters and nowhere else:
/// x'(t) = -(t - turns[0]) (t - turns[1]) ..., scaled so that x covers a range of about 1.
///
/// So x has a maximum at the last turn, a minimum at the one before it, and so on.
BezierCurve curveWithTurns(const std::vector<Real>& turns);

}  // namespace caustic
