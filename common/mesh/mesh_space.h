#pragma once

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

private:
    friend class MeshRay;

    Vec3 center_;
    Real scale_;
    Bounds3 box_;  // in the tree's coordinates, a little larger than the mesh
};

/// A ray on its way through a mesh's tree: it starts where it enters the mesh's box, however far away that is.
class MeshRay {
public:
    /// @param ray  of any length
    MeshRay(const MeshSpace& space, const Ray& ray);

    /// Whether the ray comes from so far away that its place in the tree isn't sure to a float's precision: from more
    /// than 2²⁰ sizes of the mesh. The caller has to look at all triangles then.
    bool comesFromTooFar() const { return tooFar_; }

    /// Whether it misses the mesh's box.
    bool misses() const { return !(tree.tMax >= 0); }

    /// Ends the tree's ray where the given one has t, or a little later.
    void endAt(Real t) { tree.tMax = static_cast<float>((t * length_ - start_) * roundedUp); }

    /// The same ray in the tree's coordinates.
    TreeRay tree;

private:
    static constexpr Real roundedUp = 1 + 1e-6;

    Real length_;  // t of the tree's ray for one of the given ray
    Real start_;   // where the tree's ray starts
    bool tooFar_;
};

}  // namespace caustic
