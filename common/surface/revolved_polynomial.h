#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "surface/revolved_segment.h"

/// Polynomials in Bernstein form, as RevolvedSegment asks for them millions of times.
namespace caustic::detail {

/// A bound of the second derivative on [0, 1].
inline Real bendOf(std::span<const Real> c) {
    Real largest = 0;
    for (std::size_t i = 2; i < c.size(); ++i) largest = std::max(largest, std::abs(c[i] - 2 * c[i - 1] + c[i - 2]));
    const auto n = static_cast<Real>(c.size() - 1);
    return n * (n - 1) * largest;
}

/// Value and derivative of a polynomial in Bernstein form. At u = 0 and 1 the value is the end's coefficient exactly,
/// so that two segments that share an end agree on it.
struct Jet {
    Real value;
    Real slope;
};

inline Jet evaluateCubic(const Real* c, Real u) {
    const Real v = 1 - u;
    const Real ab = v * c[0] + u * c[1];
    const Real bc = v * c[1] + u * c[2];
    const Real cd = v * c[2] + u * c[3];
    const Real abc = v * ab + u * bc;
    const Real bcd = v * bc + u * cd;
    return {v * abc + u * bcd, 3 * (bcd - abc)};
}

inline Jet evaluateAny(const Real* c, int degree, Real u) {
    std::array<Real, RevolvedSegment::highestDegree + 1> level = {};
    std::copy(c, c + degree + 1, level.begin());
    for (int left = degree; left > 1; --left) {
        for (int i = 0; i < left; ++i) {
            const auto k = static_cast<std::size_t>(i);
            level[k] = (1 - u) * level[k] + u * level[k + 1];
        }
    }
    return {(1 - u) * level[0] + u * level[1], degree * (level[1] - level[0])};
}

/// Both coordinates' jets at u.
struct ProfileJet {
    Jet x;
    Jet y;
};

inline ProfileJet evaluateProfile(const std::vector<Real>& x, const std::vector<Real>& y, Real u) {
    if (x.size() == 4) return {evaluateCubic(x.data(), u), evaluateCubic(y.data(), u)};
    const int degree = static_cast<int>(x.size()) - 1;
    return {evaluateAny(x.data(), degree, u), evaluateAny(y.data(), degree, u)};
}

}  // namespace caustic::detail
