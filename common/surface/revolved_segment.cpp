#include "surface/revolved_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/check.h"
#include "surface/revolved_polynomial.h"

namespace caustic {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

Real binomial(int n, int k) {
    Real value = 1;
    for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
    return value;
}

// Bernstein coefficients of a product (Farin, sec. 6.10).
std::vector<Real> product(const std::vector<Real>& a, const std::vector<Real>& b) {
    const int n = static_cast<int>(a.size()) - 1;
    const int m = static_cast<int>(b.size()) - 1;
    std::vector<Real> result(static_cast<std::size_t>(n + m + 1), 0);
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= m; ++j) {
            const Real weight = binomial(n, i) * binomial(m, j) / binomial(n + m, i + j);
            result[static_cast<std::size_t>(i + j)] +=
                weight * a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
        }
    }
    return result;
}

Real largestOf(const std::vector<Real>& values) {
    Real largest = 0;
    for (const Real value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

}  // namespace

RevolvedSegment::RevolvedSegment(const BezierCurve& profile) {
    checkArgument(profile.degree() >= 1 && profile.degree() <= highestDegree, "profile's degree",
                  std::to_string(profile.degree()), "must be 1 to " + std::to_string(highestDegree));
    for (const Vec3& point : profile.controlPoints()) {
        x_.push_back(point.x());
        y_.push_back(point.y());
    }
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    middle_ = *low / 2 + *high / 2;
    std::vector<Real> centred = y_;
    for (Real& y : centred) y -= middle_;
    xSquare_ = product(x_, x_);
    ySquare_ = product(centred, centred);
    yRaised_ = product(centred, std::vector<Real>(centred.size(), 1));
    xLargest_ = largestOf(x_);
    yLargest_ = largestOf(centred);
    margin_ = 1e-6 * (xLargest_ + yLargest_);
}

std::optional<RevolvedSegment::Reach> RevolvedSegment::reach(const AxisRay& ray) const {
    Reach reach = {-infinity, infinity};
    if (std::abs(ray.rise) > 1e-6) {
        const Real middle = (middle_ - ray.baseHeight) * ray.perRise;
        const Real half = (yLargest_ + margin_) * std::abs(ray.perRise);
        reach = {middle - half, middle + half};
    }
    const Real passing = ray.acrossAt(std::clamp(ray.nearest, reach.from, reach.to)).squaredNorm();
    const Real radius = xLargest_ + margin_ + 1e-12 * ray.near;
    if (passing > radius * radius) return std::nullopt;
    return reach;
}

RevolvedSegment::ProfilePoint RevolvedSegment::profileAt(Real u) const {
    const auto [x, y] = detail::evaluateProfile(x_, y_, u);
    return {{x.value, y.value}, {x.slope, y.slope}};
}

}  // namespace caustic
