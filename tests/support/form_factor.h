#pragma once

#include <cmath>
#include <numbers>

#include "math/real.h"

namespace caustic::test {

/// Share of a surface element's hemisphere, cosine-weighted, that a rectangle covers which is parallel to it, faces it
/// and has a corner straight above it: its form factor. Source: Howell, A Catalog of Radiation Heat Transfer
/// Configuration Factors, B-3; Lambert 1760.
/// @param a, b      the rectangle's sides
/// @param distance  from the element
inline Real cornerFormFactor(Real a, Real b, Real distance) {
    const Real x = a / distance;
    const Real y = b / distance;
    const Real rx = std::sqrt(1 + x * x);
    const Real ry = std::sqrt(1 + y * y);
    return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * std::numbers::pi);
}

/// The same for a rectangle [x0, x1] × [y0, y1], seen from below the origin: four corners, with their signs.
inline Real formFactor(Real x0, Real x1, Real y0, Real y1, Real distance) {
    const auto corner = [&](Real x, Real y) {
        return std::copysign(1, x) * std::copysign(1, y) * cornerFormFactor(std::abs(x), std::abs(y), distance);
    };
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

}  // namespace caustic::test
