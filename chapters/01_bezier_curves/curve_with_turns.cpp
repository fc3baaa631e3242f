#include "curve_with_turns.h"

#include <algorithm>

namespace caustic {

namespace {

// Bernstein coefficients of p(t) (t - root), of p's degree plus 1: a product of two forms (Farouki, Rajan 1988, eq.
// 44), the second one with the coefficients -root and 1 - root.
std::vector<Real> timesLinear(const std::vector<Real>& p, Real root) {
    const std::size_t degree = p.size();
    std::vector<Real> product(degree + 1, 0);
    for (std::size_t i = 0; i <= degree; ++i) {
        const Real share = static_cast<Real>(i) / static_cast<Real>(degree);
        if (i < degree) product[i] -= (1 - share) * p[i] * root;
        if (i > 0) product[i] += share * p[i - 1] * (1 - root);
    }
    return product;
}

}  // namespace

BezierCurve curveWithTurns(const std::vector<Real>& turns) {
    std::vector<Real> slope = {-1};
    for (const Real turn : turns) slope = timesLinear(slope, turn);

    std::vector<Real> x = {0};
    for (const Real coefficient : slope) x.push_back(x.back() + coefficient);
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    const Real range = *high - *low;
    std::vector<Vec3> controlPoints;
    for (std::size_t i = 0; i < x.size(); ++i) {
        controlPoints.push_back(Vec3(x[i] / range, static_cast<Real>(i) / static_cast<Real>(slope.size()), 0));
    }
    return BezierCurve(std::move(controlPoints));
}

}  // namespace caustic
