#include "measures/convergence_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace caustic {

namespace {

// Error after so many seconds, between two points along a straight line of the logarithms.
Real errorAt(const ConvergencePoints& points, double seconds) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].seconds < seconds && i + 1 < points.size()) continue;
        const Real part =
            std::log(seconds / points[i - 1].seconds) / std::log(points[i].seconds / points[i - 1].seconds);
        return points[i - 1].error * std::pow(points[i].error / points[i - 1].error, part);
    }
    return points.back().error;
}

}  // namespace

ConvergencePoints pointsOf(const ConvergencePoints& all, const std::string& scene, Method method) {
    ConvergencePoints own;
    std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                 [&](const ConvergencePoint& one) { return one.scene == scene && one.method == method; });
    return own;
}

Real slopeOf(const ConvergencePoints& points) {
    Vec2 mean = Vec2::Zero();
    const auto place = [](const ConvergencePoint& one) {
        return Vec2(std::log(static_cast<Real>(one.samples)), std::log(one.error));
    };
    for (const ConvergencePoint& one : points) mean += place(one) / static_cast<Real>(points.size());
    Real xy = 0;
    Real xx = 0;
    for (const ConvergencePoint& one : points) {
        const Vec2 off = place(one) - mean;
        xy += off.x() * off.y();
        xx += off.x() * off.x();
    }
    return xy / xx;
}

Real errorRatio(const ConvergencePoints& all, const std::string& scene, Method one, Method other) {
    const ConvergencePoints first = pointsOf(all, scene, one);
    const ConvergencePoints second = pointsOf(all, scene, other);
    const double seconds = std::min(first.back().seconds, second.back().seconds);
    return errorAt(first, seconds) / errorAt(second, seconds);
}

}  // namespace caustic
