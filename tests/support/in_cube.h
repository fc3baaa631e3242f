#pragma once

#include "core/random.h"
#include "math/vector.h"

namespace caustic::test {

/// A uniform point of the cube [-1, 1]³.
inline Vec3 inCube(Random& random) {
    const Real x = random.uniform(-1, 1);
    const Real y = random.uniform(-1, 1);
    return {x, y, random.uniform(-1, 1)};
}

}  // namespace caustic::test
