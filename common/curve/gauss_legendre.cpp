#include "curve/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/check.h"
#include "math/stable_norm.h"

namespace caustic {

namespace {

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

// Legendre polynomials P_0(x) ... P_degree(x) by Bonnet's recursion.
std::vector<Real> legendreValues(int degree, Real x) {
    std::vector<Real> values = {1, x};
    for (int k = 1; k < degree; ++k) {
        const auto i = static_cast<std::size_t>(k);
        values.push_back(((2 * k + 1) * x * values[i] - k * values[i - 1]) / (k + 1));
    }
    values.resize(static_cast<std::size_t>(degree) + 1);
    return values;
}

// v(x) = sum of coefficient[k] P_k(x); exact, since the rule integrates products of v and P_k exactly.
std::vector<Vec3> legendreCoefficients(const GaussRule& rule, std::span<const Vec3> values, int degree) {
    std::vector<Vec3> coefficients(static_cast<std::size_t>(degree) + 1, Vec3::Zero());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::vector<Real> basis = legendreValues(degree, rule.nodes[i]);
        for (std::size_t k = 0; k < coefficients.size(); ++k) {
            const Real norm = static_cast<Real>(2 * k + 1) / 2;
            coefficients[k] += norm * rule.weights[i] * basis[k] * values[i];
        }
    }
    return coefficients;
}

// Sum of sizes[k] rho^k.
Real evaluateSizes(const std::vector<Real>& sizes, Real rho) {
    Real sum = 0;
    for (std::size_t k = sizes.size(); k-- > 0;) sum = sum * rho + sizes[k];
    return sum;
}

// Trefethen's bound, for |v| = |mean| |1 + deviation|: in the ellipse of rho the deviation is at most sum sizes[k]
// rho^k, because |P_k| <= rho^k there. While that is less than |mean| the square root of v·v has no branch point.
Real ellipseBound(Real mean, const std::vector<Real>& sizes, int points) {
    const auto fits = [&](Real rho) { return evaluateSizes(sizes, rho) <= mean; };
    if (!fits(1)) return std::numeric_limits<Real>::infinity();
    Real low = 1;
    Real high = std::pow(1 / unitRoundoff, Real(0.5) / std::max(1, points - 1));
    if (fits(high)) low = high;
    for (int step = 0; step < 30 && low < high; ++step) {
        const Real middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    if (low == 1) return std::numeric_limits<Real>::infinity();
    const Real largest = mean + evaluateSizes(sizes, low);
    return Real(64) / 15 * largest * std::pow(low, 2 - 2 * points) / (1 - 1 / (low * low));
}

}  // namespace

GaussRule gaussLegendreRule(int points) {
    checkArgument(points >= 1, "points of a Gauss rule", std::to_string(points), "must be at least 1");
    GaussRule rule;
    for (int i = points; i >= 1; --i) {
        Real x = std::cos(std::numbers::pi * (i - 0.25) / (points + 0.5));
        Real slope = 1;
        for (int step = 0; step < 5; ++step) {
            const std::vector<Real> p = legendreValues(points, x);
            const auto n = static_cast<std::size_t>(points);
            slope = points * (x * p[n] - p[n - 1]) / (x * x - 1);
            x -= p[n] / slope;
        }
        if (2 * i == points + 1) x = 0;
        rule.nodes.push_back(x);
        rule.weights.push_back(2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

Real gaussSpeedError(const GaussRule& rule, std::span<const Vec3> velocities, int degree, Real velocityError) {
    Real largest = 0;
    Real sum = 0;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        const Real speed = stableNorm(velocities[i]);
        largest = std::max(largest, speed);
        sum += rule.weights[i] * speed;
    }
    if (largest == 0) return 2 * velocityError;

    const std::vector<Vec3> coefficients = legendreCoefficients(rule, velocities, degree);
    const Real noise = velocityError + 4 * rule.points() * unitRoundoff * largest;
    const Real mean = stableNorm(coefficients[0]);
    const Vec3 along = mean > 0 ? Vec3(coefficients[0] / mean) : Vec3::Zero();

    std::vector<Real> sizes = {noise};
    Real meanSquare = 0;  // in units of largest²
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const Vec3& coefficient = coefficients[k];
        const Real relative = stableNorm(coefficient) / largest;
        meanSquare += relative * relative / static_cast<Real>(2 * k + 1);
        if (k == 0) continue;
        const Real parallel = coefficient.dot(along);
        const Real across = stableNorm(Vec3(coefficient - parallel * along));
        sizes.push_back(std::abs(parallel) + across + static_cast<Real>(2 * k + 1) * noise);
    }
    const Real enclosure = std::max(2 * largest * std::sqrt(meanSquare) - sum, sum - 2 * mean) + 2 * noise;
    return std::min(enclosure, ellipseBound(mean, sizes, rule.points()));
}

}  // namespace caustic
