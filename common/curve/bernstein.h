#pragma once

#include <span>
#include <utility>
#include <vector>

#include "math/real.h"

namespace caustic {

/// Sum of C(n,i) (1-t)^(n-i) t^i c_i for n + 1 >= 1 coefficients: numbers, points or vectors.
///
/// One pass, without a triangle. For t in [0, 1] the error is at most (4 n + 4) u × the largest coefficient, u = 2^-53.
/// Source: Farin, Curves and Surfaces for CAGD (5th ed., 2002), sec. 4.8 ("hornbez").
template <typename Value>
Value evaluateBernstein(std::span<const Value> coefficients, Real t) {
    const std::size_t n = coefficients.size() - 1;
    if (n == 0) return coefficients[0];
    const Real s = 1 - t;
    Real binomial = 1;
    Real power = 1;
    Value sum = coefficients[0] * s;
    for (std::size_t i = 1; i < n; ++i) {
        power *= t;
        binomial *= static_cast<Real>(n - i + 1) / static_cast<Real>(i);
        sum = (sum + power * binomial * coefficients[i]) * s;
    }
    return sum + power * t * coefficients[n];
}

/// A polynomial over [0, 1] in Bernstein form: p(t) = sum of C(n,i) (1-t)^(n-i) t^i c_i.
class BernsteinPolynomial {
public:
    /// @param coefficients  n + 1 finite numbers for degree n; at least one
    /// @throws InputError when there is none, or one is not finite
    explicit BernsteinPolynomial(std::vector<Real> coefficients);

    /// n, one less than there are coefficients.
    int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
    /// c_0 to c_n.
    const std::vector<Real>& coefficients() const { return coefficients_; }

    /// The largest |c_i|: no value of p on [0, 1] is larger.
    Real magnitude() const;

    /// p(t), as evaluateBernstein().
    Real evaluate(Real t) const { return evaluateBernstein<Real>(coefficients_, t); }

    /// p' of one degree less; zero for degree 0. Each coefficient has a relative error of at most 2 u.
    BernsteinPolynomial derivative() const;

    /// p on [0, t] and p on [t, 1], each over its own parameter from 0 to 1.
    std::pair<BernsteinPolynomial, BernsteinPolynomial> split(Real t) const;

    /// p on [from, to], 0 <= from <= to <= 1, over its own parameter from 0 to 1.
    BernsteinPolynomial restricted(Real from, Real to) const;

private:
    std::vector<Real> coefficients_;
};

/// A root in [0, 1], or several that rounding can't tell apart.
struct BernsteinRoot {
    Real t;      ///< the root: for a simple one to within rounding, for several in one place where they meet
    Real low;    ///< the exact roots that this one stands for lie in [low, high],
    Real high;   ///< a few ulp wide for a simple, well-conditioned root, some 1e-8 for a double one
    int before;  ///< sign of p just before low: -1 or 1, or 0 when low is 0
    int after;   ///< sign of p just after high: -1 or 1, or 0 when high is 1

    /// Whether p changes its sign, that is, the roots' multiplicities sum to an odd number.
    bool crossing() const { return before * after < 0; }
};

/// What findRoots() returns.
struct BernsteinRoots {
    /// p is zero everywhere up to coefficientError. `roots` is empty then.
    bool identicallyZero = false;
    std::vector<BernsteinRoot> roots;  ///< in increasing order; their [low, high] don't overlap
};

/// All roots of p in [0, 1].
///
/// Misses nothing: for every polynomial whose coefficients differ from p's by at most `coefficientError` each, every
/// exact root in [0, 1] lies in the [low, high] of one of the returned ones.
///
/// Reports nothing else: at a returned root that is not crossing, |p| is at most 4 (n + 2)² u × magnitude() +
/// 2 coefficientError; so a double root is found, and a polynomial that misses zero by less than that counts as
/// touching.
/// - A root of multiplicity m comes once; `t` is then the root of the (m-1)th derivative (a double root's t is as good
///   as a simple one's), or the middle of [low, high] where no derivative settles it.
/// - Roots at 0 and 1 belong to it; roots outside never come back (one within rounding of an end does, as that end).
/// - All coefficients zero (up to coefficientError): identicallyZero.
///
/// Method: sign variations and bisection (Lane, Riesenfeld 1981), with a bound of the rounding carried along, and
/// Newton's method safeguarded by bisection for an isolated root.
///
/// @param coefficientError  bound of the error of each coefficient, in p's unit; finite, at least 0
BernsteinRoots findRoots(const BernsteinPolynomial& p, Real coefficientError = 0);

}  // namespace caustic
