#pragma once

#include <Eigen/Core>

#include "math/real.h"

namespace caustic {

using Vec2 = Eigen::Matrix<Real, 2, 1>;
using Vec3 = Eigen::Matrix<Real, 3, 1>;

}  // namespace caustic
