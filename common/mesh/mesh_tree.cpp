#include "mesh/mesh_tree.h"

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

std::unique_ptr<const MeshTree> plantMeshTree(MeshTreeKind kind, const std::shared_ptr<const MeshData>& mesh) {
    switch (kind) {
        case MeshTreeKind::BruteForce:
            return std::make_unique<BruteForceMesh>(mesh);
        case MeshTreeKind::MedianKdTree:
            return std::make_unique<KdMeshTree>(mesh, KdRule{.split = KdSplit::Median});
        case MeshTreeKind::SahKdTree:
            return std::make_unique<KdMeshTree>(mesh, KdRule{});
        case MeshTreeKind::WideKdTree:
            return std::make_unique<BlockMeshTree<CompactKdTree>>(mesh);
        case MeshTreeKind::WideBvh:
            return std::make_unique<BlockMeshTree<WideBvh>>(mesh);
    }
    throw InputError({"mesh tree", 0}, "", "is of no known kind");
}

}  // namespace caustic
