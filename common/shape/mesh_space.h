#pragma once

#include <optional>

#include "accel/tree_ray.h"
#include "math/bounds.h"
#include "math/ray.h"

namespace caustic {

/// The coordinates of a mesh's trees in float: its centre is the origin, and a power of two brings it into [-1, 1]³. So
/// neither the mesh's size nor its place costs digits, and floats neither overflow nor underflow.
class MeshSpace {
public:
    /// @param box  around the mesh: finite, not empty
    explicit MeshSpace(const Bounds3& box);

    /// A point in the tree's coordinates.
    Vec3 toTree(const Vec3& point) const { return (point - center_) * scale_; }

    /// Largest distance from the origin, in the tree's coordinates; at most √3.
    Real radius() const { return radius_; }

private:
    friend class MeshRay;

    Vec3 center_;
    Real scale_;
    Real radius_;
    Bounds3 box_;  // in the tree's coordinates, a little larger than the mesh
};

/// A ray on its way through a mesh's tree: it starts where it enters the mesh's box, however far away that is.
class MeshRay {
public:
    /// Nothing when the ray misses the mesh's box.
    static std::optional<MeshRay> through(const MeshSpace& space, const Ray& ray);

    /// Whether the ray comes from so far away that its place in the tree isn't sure to a float's precision: from more
    /// than 2²⁰ sizes of the mesh. Who asks has to look at all triangles then.
    static bool comesFromTooFar(const MeshSpace& space, const Ray& ray);

    /// The t of the tree's ray at which the given one has t, rounded up.
    float toTree(Real t) const { return static_cast<float>((t * length_ - start_) * (1 + 1e-6)); }

    /// The same ray in the tree's coordinates.
    TreeRay tree;

private:
    MeshRay(const TreeRay& ray, Real length, Real start) : tree(ray), length_(length), start_(start) {}

    Real length_;  // of the direction, in the tree's coordinates
    Real start_;   // way to where the tree's ray starts
};

}  // namespace caustic
