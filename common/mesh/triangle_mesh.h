#pragma once

#include <memory>

#include "mesh/mesh_tree.h"
#include "sampling/discrete_distribution.h"
#include "shape/shape.h"

namespace caustic {

/// Many triangles as one shape, with a tree of its own.
///
/// The geometric normal points to where a triangle's corners run counterclockwise, which is outside for a mesh that is
/// oriented so. Where the mesh has normals, ns is interpolated between those of the corners (Phong 1975) and turned to
/// ng's side. Where it has none, or they cancel, ns = ng. Where it has no uvs, (u, v) are the barycentric coordinates
/// of the second and third corner. Where the uvs run clockwise on a triangle, dpdu × dpdv points against ng. Triangles
/// without area are never hit.
class TriangleMesh final : public Shape {
public:
    /// @throws InputError as checkMesh does, and when no triangle has an area
    explicit TriangleMesh(MeshData mesh, MeshTreeKind kind = MeshTreeKind::WideBvh);

    /// What the mesh was made from.
    const MeshData& data() const { return *mesh_; }

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override { return tree_->occluded(ray); }
    Bounds3 bounds() const override { return bounds_; }

    /// Uniform over the area.
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

    /// Everything about a point of a triangle, given its barycentric coordinates.
    Hit hitAt(const MeshHit& found) const;

private:
    std::shared_ptr<const MeshData> mesh_;
    std::unique_ptr<const MeshTree> tree_;
    Bounds3 bounds_;
    DiscreteDistribution areas_;  // of the triangles
};

/// The shading normal at a point of a triangle: the corners' normals, each made a unit vector first, weighted by its
/// barycentric coordinates, of unit length again, on ng's side. ng itself when the mesh has no normals, a corner has
/// none (MeshData::none, or a zero one), or they cancel.
Vec3 interpolatedNormal(const MeshData& mesh, const MeshHit& at, const Vec3& ng);

}  // namespace caustic
