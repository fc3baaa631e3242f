#pragma once

#include "image/ray_view.h"
#include "surface/newton_revolution.h"

namespace caustic {

/// What Newton's method makes of one ray at a revolved curve.
enum class Outcome {
    Empty,    ///< the ray misses the surface, and Newton says so
    Right,    ///< the nearest meeting
    Farther,  ///< a meeting, but not the nearest
    Lost      ///< none, though there is one
};

/// Runs Newton's method from the curve's bracketing starts, or from the one at (u, v).
Outcome outcomeOf(const BezierCurve& profile, const RevolvedCurve& curve, const Ray& ray, bool bracketing,
                  const Vec2& start);

}  // namespace caustic
