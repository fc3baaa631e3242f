#pragma once

#include <array>

namespace caustic {

/// A ray in the coordinates of a tree in float, with what every node needs computed once.
///
/// Such a tree has its own coordinates, in which all that it holds fits into the cube [-1, 1]³. The ray starts in or
/// near that cube, and its direction's largest component is between 1 and 2, so that nothing there is farther than
/// t = 4. What it meets are candidates, to be looked at more closely by whoever knows the ray in full precision.
struct TreeRay {
    std::array<float, 3> origin;   ///< where t = 0
    std::array<float, 3> inverse;  ///< 1 / direction; where that is next to zero, huge but finite
    float tMax;                    ///< nothing beyond it counts
};

/// How far from its true place a TreeRay may be when a node is tested against it: the origin's rounding (2⁻²⁴), those
/// of the direction and of its inverse over the way to a plane of the cube (2 · 2⁻²⁴ each), those of a crossing
/// (4 · 2⁻²⁴), and that of the direction's replaced components (far less). Nodes are larger by it on all sides.
inline constexpr float treeRayPadding = 0x1p-20F;

}  // namespace caustic
