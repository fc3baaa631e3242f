#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "accel/kd_build.h"
#include "math/ray.h"
#include "mesh/mesh_data.h"
#include "shape/triangle_hit.h"

namespace caustic {

/// Where a ray meets a mesh.
struct MeshHit : TriangleHit {
    std::uint32_t triangle;  ///< of MeshData::triangles
};

/// What a ray costs, counted.
struct MeshWork {
    std::uint64_t nodes = 0;  ///< that were visited
    std::uint64_t tests = 0;  ///< of single triangles, or of blocks of eight at once
};

/// How large a tree is.
struct MeshTreeSize {
    std::size_t bytes = 0;       ///< of nodes and leaves, without the mesh's own arrays
    std::size_t nodes = 0;       ///< leaves included, unless they are blocks without a node
    std::size_t references = 0;  ///< triangles of all leaves: more than the mesh has, where trees cut space
    int depth = 0;
    std::uint64_t buildWork = 0;  ///< events that the builder of a plain KD-tree looked at; 0 for others
};

/// The ways to find the triangle that a ray meets.
enum class MeshTreeKind {
    BruteForce,    ///< all triangles, one after the other
    MedianKdTree,  ///< KD-tree with planes through the middle
    SahKdTree,     ///< KD-tree by the surface area heuristic, one triangle at a time
    WideKdTree,    ///< KD-tree by the surface area heuristic in float, leaves of eight triangles at once
    WideBvh,       ///< hierarchy of boxes, eight children and eight triangles at once
};

/// All of them, in that order.
inline constexpr MeshTreeKind allMeshTrees[] = {MeshTreeKind::BruteForce, MeshTreeKind::MedianKdTree,
                                                MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree,
                                                MeshTreeKind::WideBvh};

/// As charts and tables call it: "wide BVH".
std::string name(MeshTreeKind kind);

/// Finds triangles of a mesh. All kinds agree with each other: whatever a tree does on the way, it accepts a triangle
/// by intersectWatertight, in `Real`, and the nearest one that is accepted wins.
class MeshTree {
public:
    virtual ~MeshTree() = default;

    /// The nearest hit with tMin < t < tMax.
    virtual std::optional<MeshHit> intersect(const Ray& ray) const = 0;

    /// Whether anything is hit with tMin < t < tMax.
    virtual bool occluded(const Ray& ray) const = 0;

    /// The same as intersect, and what it cost is added to `work`.
    virtual std::optional<MeshHit> intersectCounted(const Ray& ray, MeshWork& work) const = 0;

    /// What the tree takes.
    virtual MeshTreeSize size() const = 0;
};

/// Plants a tree over the triangles of a mesh that have an area.
/// @param mesh  as checkMesh wants it; not changed any more
std::unique_ptr<const MeshTree> plantMeshTree(MeshTreeKind kind, const std::shared_ptr<const MeshData>& mesh);

}  // namespace caustic
