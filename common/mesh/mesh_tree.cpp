#include "mesh/mesh_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/check.h"
#include "mesh/block_mesh_tree.h"
#include "mesh/kd_mesh_tree.h"

namespace caustic {

std::string name(MeshTreeKind kind) {
    switch (kind) {
        case MeshTreeKind::BruteForce:
            return "brute force";
        case MeshTreeKind::MedianKdTree:
            return "median KD-tree";
        case MeshTreeKind::SahKdTree:
            return "SAH KD-tree";
        case MeshTreeKind::WideKdTree:
            return "8-wide KD-tree";
        case MeshTreeKind::WideBvh:
            return "8-wide BVH";
    }
    throw InputError({"mesh tree", 0}, "", "is of no known kind");
}

namespace {

// Whether a number is a float. By its bits: GCC 12 makes x of static_cast<Real>(static_cast<float>(x)) in a loop that
// it vectorises.
bool isFloat(Real x) {
    constexpr std::uint64_t beyondFloat = 0x1fffffffU;
    const Real size = std::abs(x);
    return x == 0 || ((std::bit_cast<std::uint64_t>(x) & beyondFloat) == 0 && size >= 0x1p-126 && size < 0x1p128);
}

// Whether the blocks may hold floats, and nothing is lost.
bool isInFloats(const MeshData& mesh) {
    return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& position) {
        return isFloat(position.x()) && isFloat(position.y()) && isFloat(position.z());
    });
}

template <typename Tree>
std::unique_ptr<const MeshTree> plantBlocks(const std::shared_ptr<const MeshData>& mesh) {
    if (isInFloats(*mesh)) return std::make_unique<BlockMeshTree<Tree, float>>(mesh);
    return std::make_unique<BlockMeshTree<Tree, Real>>(mesh);
}

}  // namespace

std::unique_ptr<const MeshTree> plantMeshTree(MeshTreeKind kind, const std::shared_ptr<const MeshData>& mesh) {
    switch (kind) {
        case MeshTreeKind::BruteForce:
            return std::make_unique<BruteForceMesh>(mesh);
        case MeshTreeKind::MedianKdTree:
            return std::make_unique<KdMeshTree>(mesh, KdRule{.split = KdSplit::Median});
        case MeshTreeKind::SahKdTree:
            return std::make_unique<KdMeshTree>(mesh, KdRule{});
        case MeshTreeKind::WideKdTree:
            return plantBlocks<CompactKdTree>(mesh);
        case MeshTreeKind::WideBvh:
            return plantBlocks<WideBvh>(mesh);
    }
    throw InputError({"mesh tree", 0}, "", "is of no known kind");
}

}  // namespace caustic
