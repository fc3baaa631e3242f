#pragma once

#include <Eigen/Geometry>

#include "math/real.h"

namespace caustic {

/// Axis-aligned rectangle; a default-constructed one is empty and grows by extend().
using Bounds2 = Eigen::AlignedBox<Real, 2>;

/// Axis-aligned box; a default-constructed one is empty and grows by extend().
using Bounds3 = Eigen::AlignedBox<Real, 3>;

}  // namespace caustic
