#pragma once

#include <Eigen/Core>

#include "math/real.h"

namespace caustic {

/// A point, direction or pair of parameters in the plane.
using Vec2 = Eigen::Matrix<Real, 2, 1>;
/// A point or direction in space.
using Vec3 = Eigen::Matrix<Real, 3, 1>;

}  // namespace caustic
