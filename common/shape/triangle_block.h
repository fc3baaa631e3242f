#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "accel/float8.h"
#include "accel/tree_ray.h"
#include "shape/mesh_data.h"
#include "shape/mesh_space.h"

namespace caustic {

/// Eight triangles in a mesh's tree coordinates, to be tested at once in float.
///
/// The test nominates: it lets no triangle go that the watertight test would accept, and lets a few through that it
/// won't. How far its numbers may be off is bounded as follows. All lengths are in tree coordinates: the mesh is in a
/// ball of radius R, the ray starts in there and its direction d is a unit vector, edges are at most m long, ε = 2⁻²⁴.
/// With s = o - v0, p = d × e2, q = s × e1 the test computes det = e1·p, U = s·p, V = d·q and T = e2·q. In U, each
/// input is rounded: s by 4√3 ε R (origin, corner, difference), which costs 7 ε R m; d by ε and e2 by ε m, which cost
/// 2 ε R m each, for |s| ≤ 2R; the cross product costs 8 ε R m, the dot product 6 ε R m; in all 25 ε R m. V is the
/// same, det is off by 10 ε m² ≤ 20 ε R m, T by 25 ε R m². The margins are 40 ε R m for U and V, twice that for their
/// sum, and for T, to be compared with tMax det where tMax ≤ 4, 80 ε R m².
struct alignas(32) TriangleBlock {
    Float8 v0[3];  ///< first corner; NaN where there is no triangle, which no comparison accepts
    Float8 e1[3];  ///< to the second corner
    Float8 e2[3];  ///< to the third
    std::array<std::uint32_t, 8> triangle;
    float margin;    ///< of U and V
    float marginT;   ///< of T
    float leastDet;  ///< below it 1 / det is good for nothing
};

/// A TreeRay in all lanes.
struct Ray8 {
    explicit Ray8(const TreeRay& ray);

    Float8 origin[3];     ///< a component in all lanes
    Float8 direction[3];  ///< likewise
};

/// What the test of a block found.
struct Nominees {
    unsigned lanes = 0;  ///< triangles that may be hit
    unsigned sure = 0;   ///< those among them that certainly are
    Float8 t;            ///< where
    Float8 error;        ///< and by how much that may be off

    /// The least t at which the triangle may be hit; 0 when that isn't known.
    float earliest(unsigned lane) const { return t[lane] > error[lane] ? t[lane] - error[lane] : 0; }
};

/// Makes blocks of the triangles that a tree put together.
/// @param items  eight for each block; beyond `triangles` where there are less
/// @param triangles  the mesh's number for each item
std::vector<TriangleBlock> makeTriangleBlocks(const MeshData& mesh, const MeshSpace& space,
                                              std::span<const std::uint32_t> items,
                                              std::span<const std::uint32_t> triangles);

/// Which triangles of the block the ray may meet between 0 and tMax.
inline Nominees nominate(const TriangleBlock& block, const Ray8& ray, float tMax) {
    const auto& [dx, dy, dz] = ray.direction;
    const auto& [e1x, e1y, e1z] = block.e1;
    const auto& [e2x, e2y, e2z] = block.e2;
    const Float8 px = fms8(dy, e2z, dz * e2y);
    const Float8 py = fms8(dz, e2x, dx * e2z);
    const Float8 pz = fms8(dx, e2y, dy * e2x);
    const Float8 signedDet = fma8(e1x, px, fma8(e1y, py, e1z * pz));
    const Float8 sx = ray.origin[0] - block.v0[0];
    const Float8 sy = ray.origin[1] - block.v0[1];
    const Float8 sz = ray.origin[2] - block.v0[2];
    const Float8 qx = fms8(sy, e1z, sz * e1y);
    const Float8 qy = fms8(sz, e1x, sx * e1z);
    const Float8 qz = fms8(sx, e1y, sy * e1x);
    const Float8 u = turnSign8(fma8(sx, px, fma8(sy, py, sz * pz)), signedDet);
    const Float8 v = turnSign8(fma8(dx, qx, fma8(dy, qy, dz * qz)), signedDet);
    const Float8 numerator = turnSign8(fma8(e2x, qx, fma8(e2y, qy, e2z * qz)), signedDet);
    const Float8 det = turnSign8(signedDet, signedDet);

    const Float8 margin = broadcast8(block.margin);
    const Float8 marginT = broadcast8(block.marginT);
    const Float8 rest = det - (u + v);
    const Float8 farthest = broadcast8(tMax) * det;
    Nominees found;
    const Int8 inside = (u >= -margin) & (v >= -margin) & (rest >= -2 * margin);
    found.lanes = lanesOf(inside & (numerator >= -marginT) & (numerator <= farthest + marginT));
    if (found.lanes == 0) return found;
    const Int8 wellInside = (u >= margin) & (v >= margin) & (rest >= 2 * margin);
    found.sure = lanesOf(wellInside & (numerator >= marginT) & (numerator <= farthest - marginT));
    found.t = numerator / det;
    // With det above twice its own error, 1 / det is at most doubled by it.
    const Int8 known = det > broadcast8(block.leastDet);
    found.error = known ? 2 * marginT / det : broadcast8(std::numeric_limits<float>::infinity());
    return found;
}

}  // namespace caustic
