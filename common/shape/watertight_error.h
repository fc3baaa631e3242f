#pragma once

#include <limits>

#include "math/real.h"

namespace caustic {

/// Bound on the rounding error of n operations. Source: Higham 2002, lemma 3.1.
constexpr Real roundingBound(int n) {
    constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
    return n * unitRoundoff / (1 - n * unitRoundoff);
}

/// Bound on the rounding error of u az + v bz + w cz, by which the watertight test finds t. For one triangle (Real) or
/// for many (WideReal).
/// Source: Pharr, Jakob, Humphreys 2016, Physically Based Rendering, 3rd ed., section 3.9.6.
/// @param x,y,z  the corners' largest coordinates in the ray's space, without their signs
/// @param edge   the largest of u, v, w, without its sign
template <typename Number>
Number watertightError(const Number& x, const Number& y, const Number& z, const Number& edge) {
    const Number errorX = roundingBound(5) * (x + z);
    const Number errorY = roundingBound(5) * (y + z);
    const Number errorZ = roundingBound(3) * z;
    const Number errorEdge = 2 * (roundingBound(2) * x * y + errorY * x + errorX * y);
    return 3 * (roundingBound(3) * edge * z + errorEdge * z + errorZ * edge);
}

}  // namespace caustic
