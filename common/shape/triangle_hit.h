#pragma once

#include "math/real.h"

namespace caustic {

/// Where a ray meets a triangle abc: at (1 - b1 - b2) · a + b1 · b + b2 · c.
struct TriangleHit {
    Real t;   ///< in lengths of the ray's direction
    Real b1;  ///< barycentric coordinate of b
    Real b2;  ///< barycentric coordinate of c
};

}  // namespace caustic
