#pragma once

#include <memory>
#include <vector>

#include "accel/compact_kd_tree.h"
#include "accel/wide_bvh.h"
#include "mesh/mesh_space.h"
#include "mesh/mesh_tree.h"
#include "mesh/triangle_block.h"

namespace caustic {

/// A tree in float over blocks of eight triangles, of either kind.
///
/// The tree only says where to look, with margins for its rounding. The blocks hold what the watertight test needs, so
/// a hit is final as soon as it is found, and nothing of the mesh is fetched for it. What was tried instead, and what
/// it cost, is in docs/rays.md.
/// @tparam Stored  float for a mesh all of whose coordinates are floats, as in most files: blocks are half as large
/// then,
///                 and as exact; Real for others
template <typename Tree, typename Stored>
class BlockMeshTree final : public MeshTree {
public:
    /// @param mesh  as checkMesh wants it, with a triangle that has an area
    explicit BlockMeshTree(std::shared_ptr<const MeshData> mesh);

    std::optional<MeshHit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    std::optional<MeshHit> intersectCounted(const Ray& ray, MeshWork& work) const override;
    /// What the tree takes.
    MeshTreeSize size() const override;

private:
    BlockMeshTree(std::shared_ptr<const MeshData> mesh, const std::vector<std::uint32_t>& triangles);

    template <bool any, bool counted>
    std::optional<MeshHit> search(const Ray& ray, MeshWork* work) const;

    template <bool any>
    std::optional<MeshHit> searchAll(const Ray& ray) const;

    std::shared_ptr<const MeshData> mesh_;
    MeshSpace space_;
    Tree tree_;
    std::vector<TriangleBlock<Stored>> blocks_;
    std::size_t references_ = 0;
};

extern template class BlockMeshTree<CompactKdTree, float>;
extern template class BlockMeshTree<CompactKdTree, Real>;
extern template class BlockMeshTree<WideBvh, float>;
extern template class BlockMeshTree<WideBvh, Real>;

}  // namespace caustic
