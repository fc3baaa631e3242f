#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vector.h"

namespace caustic {

/// Triangles that share vertices.
struct IndexedTriangles {
    std::vector<Vec3> vertices;                           ///< points, in no particular order
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices, counterclockwise from outside
};

}  // namespace caustic
