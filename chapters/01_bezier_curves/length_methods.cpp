#include "length_methods.h"

#include <Eigen/Geometry>
#include <cmath>

namespace caustic {

Real plainGaussLength(const BezierCurve& curve, const GaussRule& rule) {
    Real sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        sum += rule.weights[i] * curve.derivative((1 + rule.nodes[i]) / 2).norm();
    }
    return sum / 2;
}

BezierCurve cuspidalCubic(Real cusp, Real size, Real angle) {
    const Eigen::AngleAxis<Real> turn(angle, Vec3::UnitZ());
    std::vector<Vec3> controlPoints;
    // Blossoms of u² and u³ (Farin 2002, sec. 4.4): control point i takes i of its three arguments at t = 1.
    for (int i = 0; i <= 3; ++i) {
        const Real a = i > 2 ? 1 - cusp : -cusp;
        const Real b = i > 1 ? 1 - cusp : -cusp;
        const Real c = i > 0 ? 1 - cusp : -cusp;
        controlPoints.push_back(turn * Vec3(size * (a * b + a * c + b * c) / 3, size * a * b * c, 0));
    }
    return BezierCurve(std::move(controlPoints));
}

Real cuspidalCubicLength(Real cusp, Real size) {
    const auto fromCusp = [](Real u) { return (std::pow(4 + 9 * u * u, Real(1.5)) - 8) / 27; };
    return size * (fromCusp(cusp) + fromCusp(1 - cusp));
}

}  // namespace caustic
