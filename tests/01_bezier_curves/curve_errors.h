#pragma once

#include <algorithm>
#include <cmath>

#include "curve/bezier_curve.h"
#include "support/reference_curve.h"

namespace caustic::test {

/// Largest coordinate of the control points: what errors are measured by.
inline Real sizeOf(const BezierCurve& curve) {
    Real size = 0;
    for (const Vec3& point : curve.controlPoints()) size = std::max(size, point.cwiseAbs().maxCoeff());
    return size;
}

/// Largest difference of a coordinate between a point and what it ought to be.
inline Real distance(const Vec3& point, const QuadPoint& truth) {
    Real largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Quad difference = truth[axis] - point[static_cast<Eigen::Index>(axis)];
        largest = std::max(largest, std::abs(static_cast<Real>(difference)));
    }
    return largest;
}

}  // namespace caustic::test
