#include "accel/tree_ray.h"

#include <cmath>

namespace caustic {

TreeRay::TreeRay(const std::array<float, 3>& from, const std::array<float, 3>& along, float most)
    : origin(from), direction(along), tMax(most) {
    constexpr float tiny = 1e-15F;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const float safe = std::abs(along[axis]) < tiny ? std::copysign(tiny, along[axis]) : along[axis];
        inverse[axis] = 1 / safe;
    }
}

}  // namespace caustic
