#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "curve/bezier_curve.h"

namespace caustic::test {

/// A number with a 113-bit significand: its rounding, 1e-34, is nothing beside that of double.
using Quad = boost::multiprecision::cpp_bin_float_quad;
using QuadPoint = std::array<Quad, 3>;

/// Judge of BezierCurve: the same curve in 113-bit arithmetic, up to degree 60.
///
/// Shares no evaluation code with what it judges: positions and velocities are plain Bernstein sums with exact integer
/// binomials; lengths come from bisection down to every cusp, extrema from sampling and golden sections.
class ReferenceCurve {
public:
    explicit ReferenceCurve(const BezierCurve& curve);

    /// B(t) and B'(t). Any t.
    QuadPoint position(const Quad& t) const;
    QuadPoint velocity(const Quad& t) const;

    /// Arc length, to about 1e-17 of the control polygon's.
    Quad length() const;

    /// A coordinate's smallest and largest value on [0, 1]: values that the curve takes, so never outside; to about
    /// 1e-20.
    struct Range {
        Quad low;
        Quad high;
    };
    Range range(int axis) const;

private:
    std::array<std::vector<Quad>, 3> coordinates_;  // of the control points, axis by axis
    std::array<std::vector<Quad>, 3> differences_;  // of neighbours, times the degree
};

}  // namespace caustic::test
