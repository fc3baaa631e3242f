#pragma once

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <span>
#include <vector>

#include "math/vector.h"
#include "measures/reference_113bit.h"

namespace caustic {

/// The judge of every length: the integral of |B'(t)| over [0, 1] in 113 bits, by Boost's tanh-sinh quadrature.
///
/// It shares no code and no method with what it judges. Tanh-sinh bears corners at the ends of an interval, so `cusps`
/// names the parameters in (0, 1), in increasing order, where B' vanishes. Error: some 10^-25 of the length.
inline Real113 referenceLength(std::span<const Vec3> controlPoints, const std::vector<Real113>& cusps = {}) {
    const std::size_t n = controlPoints.size() - 1;
    std::vector<Vec3> differences;
    for (std::size_t i = 0; i < n; ++i) differences.push_back(controlPoints[i + 1] - controlPoints[i]);
    const auto speed = [&](const Real113& t) -> Real113 {
        const Point113 mean = referencePosition<double>(differences, t);
        return n * sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
    };

    std::vector<Real113> ends = cusps;
    ends.insert(ends.begin(), 0);
    ends.push_back(1);
    boost::math::quadrature::tanh_sinh<Real113> integrator;
    Real113 length = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        length += integrator.integrate(speed, ends[i], ends[i + 1], Real113(1e-25));
    }
    return length;
}

}  // namespace caustic
