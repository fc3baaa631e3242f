#pragma once

#include "math/vector.h"

namespace caustic {

/// A point of a parametric surface and how it moves with the parameters.
struct SurfaceJet {
    Vec3 point;
    Vec3 du;  ///< ∂B/∂u
    Vec3 dv;  ///< ∂B/∂v
};

}  // namespace caustic
