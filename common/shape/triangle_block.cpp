#include "shape/triangle_block.h"

#include <algorithm>
#include <limits>

namespace caustic {

namespace {

constexpr Real roundoff = 0x1p-24;

// Keeps margins away from the smallest floats, whose products vanish.
constexpr Real leastMargin = 1e-36;

void setLane(TriangleBlock& block, unsigned lane, const std::array<Vec3, 3>& rows) {
    for (int axis = 0; axis < 3; ++axis) {
        block.v0[axis][lane] = static_cast<float>(rows[0][axis]);
        block.e1[axis][lane] = static_cast<float>(rows[1][axis]);
        block.e2[axis][lane] = static_cast<float>(rows[2][axis]);
    }
}

}  // namespace

Ray8::Ray8(const TreeRay& ray) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        origin[axis] = broadcast8(ray.origin[axis]);
        direction[axis] = broadcast8(ray.direction[axis]);
    }
}

std::vector<TriangleBlock> makeTriangleBlocks(const MeshData& mesh, const MeshSpace& space,
                                              std::span<const std::uint32_t> items,
                                              std::span<const std::uint32_t> triangles) {
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<Real>::quiet_NaN());
    std::vector<TriangleBlock> blocks(items.size() / 8);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        TriangleBlock& block = blocks[i];
        Real longest = 0;
        for (unsigned lane = 0; lane < 8; ++lane) {
            const std::uint32_t item = items[8 * i + lane];
            if (item >= triangles.size()) {
                setLane(block, lane, {nowhere, Vec3::Zero(), Vec3::Zero()});
                block.triangle[lane] = MeshData::none;
                continue;
            }
            block.triangle[lane] = triangles[item];
            const auto [a, b, c] = mesh.corners(triangles[item]);
            const Vec3 e1 = space.toTree(b) - space.toTree(a);
            const Vec3 e2 = space.toTree(c) - space.toTree(a);
            setLane(block, lane, {space.toTree(a), e1, e2});
            longest = std::max({longest, e1.norm(), e2.norm()});
        }
        const Real error = roundoff * space.radius() * longest;
        block.margin = static_cast<float>(std::max(40 * error, leastMargin));
        block.marginT = static_cast<float>(std::max(80 * error * longest, leastMargin));
        block.leastDet = static_cast<float>(std::max(20 * roundoff * longest * longest, leastMargin));
    }
    return blocks;
}

}  // namespace caustic
