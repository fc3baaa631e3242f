#pragma once

#include "accel/kd_tree.h"
#include "mesh/mesh_tree.h"

namespace caustic {

/// Every triangle is tested: what all trees are judged by.
class BruteForceMesh final : public MeshTree {
public:
    /// @param mesh  as checkMesh wants it
    explicit BruteForceMesh(std::shared_ptr<const MeshData> mesh);

    std::optional<MeshHit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    std::optional<MeshHit> intersectCounted(const Ray& ray, MeshWork& work) const override;
    /// What the tree takes.
    MeshTreeSize size() const override { return {}; }

private:
    std::shared_ptr<const MeshData> mesh_;
    std::vector<std::uint32_t> triangles_;
};

/// A KD-tree with one triangle tested at a time, all in `Real`: what one writes first, and reads first.
class KdMeshTree final : public MeshTree {
public:
    /// @param mesh  as checkMesh wants it
    KdMeshTree(std::shared_ptr<const MeshData> mesh, const KdRule& rule);

    std::optional<MeshHit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    std::optional<MeshHit> intersectCounted(const Ray& ray, MeshWork& work) const override;
    /// What the tree takes.
    MeshTreeSize size() const override;

    /// Its planes: to be drawn. Items are indices of trianglesWithArea.
    const KdTree& tree() const { return tree_; }

private:
    std::shared_ptr<const MeshData> mesh_;
    std::vector<std::uint32_t> triangles_;
    KdTree tree_;
};

}  // namespace caustic
