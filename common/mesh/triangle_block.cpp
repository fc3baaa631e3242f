#include "mesh/triangle_block.h"

#include <limits>

namespace caustic {

template <typename Stored>
std::vector<TriangleBlock<Stored>> makeTriangleBlocks(const MeshData& mesh, std::span<const std::uint32_t> items,
                                                      std::span<const std::uint32_t> triangles) {
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<Real>::quiet_NaN());
    std::vector<TriangleBlock<Stored>> blocks(items.size() / 8);
    for (std::size_t i = 0; i < items.size(); ++i) {
        TriangleBlock<Stored>& block = blocks[i / 8];
        const auto lane = static_cast<unsigned>(i % 8);
        const bool there = items[i] < triangles.size();
        block.triangle[lane] = there ? triangles[items[i]] : MeshData::none;
        const auto corners = there ? mesh.corners(triangles[items[i]]) : std::array{nowhere, nowhere, nowhere};
        auto& wide = block.parts[lane / wideRealLanes].corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                wide[corner][axis][lane % wideRealLanes] = static_cast<Stored>(corners[corner][static_cast<int>(axis)]);
            }
        }
    }
    return blocks;
}

template std::vector<TriangleBlock<float>> makeTriangleBlocks(const MeshData&, std::span<const std::uint32_t>,
                                                              std::span<const std::uint32_t>);
template std::vector<TriangleBlock<Real>> makeTriangleBlocks(const MeshData&, std::span<const std::uint32_t>,
                                                             std::span<const std::uint32_t>);

}  // namespace caustic
