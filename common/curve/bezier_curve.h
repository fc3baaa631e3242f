#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "math/vector.h"

namespace caustic {

/// A Bézier curve of any degree in space: B(t) = sum of C(n,i) (1-t)^(n-i) t^i P_i.
///
/// Coordinates have whatever unit the control points have. Results are finite as long as degree × the differences of
/// the control points are (coordinates up to about 1e300).
/// Source: Farin, Curves and Surfaces for CAGD (5th ed., 2002), ch. 4 and 5. Tests: tests/01_bezier_curves.
class BezierCurve {
public:
    /// @param controlPoints  n + 1 finite points for degree n; at least one
    /// @throws InputError when there is none, or a coordinate is not finite
    explicit BezierCurve(std::vector<Vec3> controlPoints);

    /// n, one less than there are control points.
    int degree() const { return static_cast<int>(controlPoints_.size()) - 1; }
    /// P_0 to P_n.
    const std::vector<Vec3>& controlPoints() const { return controlPoints_; }

    /// The point at t by de Casteljau's algorithm. Any finite t; outside [0, 1] the polynomial goes on.
    ///
    /// For t in [0, 1] the error of a coordinate is at most 3 n u × the largest control coordinate, u = 2^-53.
    Vec3 position(Real t) const;

    /// dB/dt at t: degree × the difference of the last pair in de Casteljau's triangle. Any finite t; zero for degree
    /// 0.
    Vec3 derivative(Real t) const;

    /// The unit direction in which the curve leaves B(t) as t grows; at t >= 1 the one in which it arrives.
    ///
    /// Where the derivative is zero up to rounding (coincident control points, a cusp) it is the limit of the direction
    /// of B'(s) for s -> t from above (at t >= 1 from below). Nothing for a curve that is a single point.
    std::optional<Vec3> tangent(Real t) const;

    /// The curve on [0, t] and the curve on [t, 1], each over its own parameter from 0 to 1 and of the same degree. Any
    /// finite t: outside [0, 1] one of them goes beyond this curve. The first part ends at the very point, bit for bit,
    /// with which the second one begins.
    std::pair<BezierCurve, BezierCurve> split(Real t) const;

    /// De Casteljau's triangle: level r has the n + 1 - r points that r rounds of interpolation leave, so the first
    /// level is the control points and the last one the point at t alone. For drawing.
    std::vector<std::vector<Vec3>> construction(Real t) const;

    /// The curve t -> B'(t), of one degree less; for degree 0 the curve that stays at zero.
    BezierCurve hodograph() const;

private:
    std::vector<Vec3> controlPoints_;
};

}  // namespace caustic
