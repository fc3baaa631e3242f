#pragma once

#include <span>
#include <vector>

#include "math/vector.h"

namespace caustic {

/// Gauss–Legendre quadrature on [-1, 1]: integral of f ≈ sum of weights[i] f(nodes[i]), exact for polynomials up to
/// degree 2 points - 1.
struct GaussRule {
    std::vector<Real> nodes;    ///< in increasing order, symmetric about 0
    std::vector<Real> weights;  ///< positive; they sum to 2

    /// How many nodes there are.
    int points() const { return static_cast<int>(nodes.size()); }
};

/// The rule with that many points; nodes and weights to within a few units of 1e-16.
///
/// Source: Newton's method on the Legendre polynomial from Tricomi's starting values (Hale, Townsend 2013, sec. 2).
/// @param points  at least 1
/// @throws InputError when points < 1
GaussRule gaussLegendreRule(int points);

/// Bound of the rule's error for a speed: of |integral over [-1, 1] of |v(x)| dx - sum of weights[i] |v(nodes[i])||.
///
/// v is a vector polynomial of that degree, less than rule.points(), so that its values at the nodes determine it. Two
/// proven bounds, the smaller one counts:
/// - |v| is analytic wherever v stays away from 0. Its Legendre coefficients tell how large an ellipse with parameter
/// rho
///   around [-1, 1] is free of zeros; there the error is at most 64/15 M rho^(2 - 2 points) / (1 - rho^-2), M the
///   largest modulus in the ellipse (Trefethen, Approximation Theory and Approximation Practice, 2013, thm. 19.3).
/// - Near a cusp there is no such ellipse, but the integral lies between 2 |mean of v| (the chord) and 2 × the root
/// mean
///   square of |v| (Cauchy–Schwarz), and both shrink with the piece.
///
/// @param velocities     v at the rule's nodes
/// @param velocityError  bound of the error of each velocity; the bound allows for it where it decides, but doesn't
///                       include 2 velocityError for the sum itself
Real gaussSpeedError(const GaussRule& rule, std::span<const Vec3> velocities, int degree, Real velocityError);

}  // namespace caustic
