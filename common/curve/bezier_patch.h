#pragma once

#include <utility>
#include <vector>

#include "curve/surface_jet.h"
#include "math/bounds.h"

namespace caustic {

/// A tensor-product Bézier patch of any two degrees: B(u, v) = sum of b_i(u) c_j(v) P_ij with Bernstein polynomials b_i
/// of degree m and c_j of degree n.
///
/// Source: Farin, Curves and Surfaces for CAGD (5th ed., 2002), ch. 14. Tests: tests/03_bezier_surfaces.
class BezierPatch {
public:
    /// @param degreeU  m, at least 1
    /// @param degreeV  n, at least 1
    /// @param points   (m + 1)(n + 1) finite control points, row by row: P_ij stands at i (n + 1) + j
    /// @throws InputError for another number of points, a degree below 1 or a coordinate that is not finite
    BezierPatch(int degreeU, int degreeV, std::vector<Vec3> points);

    /// m and n.
    int degreeU() const { return degreeU_; }
    int degreeV() const { return degreeV_; }
    /// All P_ij, row by row.
    const std::vector<Vec3>& controlPoints() const { return points_; }
    /// P_ij.
    const Vec3& controlPoint(int i, int j) const { return points_[static_cast<std::size_t>(i * (degreeV_ + 1) + j)]; }

    /// Point and partial derivatives at (u, v), by de Casteljau's algorithm in v for each row and in u for what comes
    /// out. Any finite parameters; outside [0, 1]² the polynomial goes on.
    SurfaceJet evaluate(Real u, Real v) const;

    /// The patch on v in [0, t] and on [t, 1], each over its own parameter from 0 to 1 and of the same degrees. Any
    /// finite t. Along the cut both have the very same points, bit for bit: a crack of one rounding lets rays
    /// through.
    std::pair<BezierPatch, BezierPatch> splitV(Real t) const;

    /// The box of the control points, which holds the patch on [0, 1]².
    Bounds3 bounds() const;

private:
    int degreeU_;
    int degreeV_;
    std::vector<Vec3> points_;
};

}  // namespace caustic
