#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

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
    // Always part of the loop's own function: 2 % more rays.
    /// @param ray  of any length
    [[gnu::always_inline]] MeshRay(const MeshSpace& space, const Ray& ray);

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
    static constexpr Real farthest = 0x1p20;
    // No way through the cube [-1, 1]³ is longer than 2√3, and directions are 1 long at least.
    static constexpr Real longestWay = 4;

    // The largest power of two that is not above x > 0. A mask, because std::ilogb and std::exp2 take longer than a
    // node.
    static Real powerOfTwoBelow(Real x) {
        constexpr std::uint64_t exponentBits = 0x7ff0000000000000U;
        return std::bit_cast<Real>(std::bit_cast<std::uint64_t>(x) & exponentBits);
    }

    // A component of the direction that is smaller than 1e-15 counts as that much.
    static constexpr Real largestInverse = 1e15;

    Real length_;  // t of the tree's ray for one of the given ray
    Real start_;   // where the tree's ray starts
    bool tooFar_;
};

// In the header, so that what it computes stays in registers: 5 % more rays.
inline MeshRay::MeshRay(const MeshSpace& space, const Ray& ray) {
    const Vec3 origin = space.toTree(ray.origin);
    tooFar_ = !(origin.cwiseAbs().maxCoeff() < farthest);

    // A power of two that makes the largest component one between 1 and 2 does not round, unlike the length. The
    // inverses don't wait for it: 4 % more rays.
    const Vec3 scaled = ray.direction * space.scale_;
    length_ = powerOfTwoBelow(scaled.cwiseAbs().maxCoeff());
    const Vec3 inverse = (scaled.cwiseInverse() * length_).cwiseMax(-largestInverse).cwiseMin(largestInverse);
    for (unsigned axis = 0; axis < 3; ++axis) tree.inverse[axis] = static_cast<float>(inverse[static_cast<int>(axis)]);

    start_ = ray.tMin * length_;
    Real end = start_ + longestWay;
    Vec3 from = origin;
    if (start_ != 0 || !space.box_.contains(origin)) {
        end = std::numeric_limits<Real>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const Real lower = (space.box_.min()[axis] - origin[axis]) * inverse[axis];
            const Real upper = (space.box_.max()[axis] - origin[axis]) * inverse[axis];
            start_ = std::max(start_, std::min(lower, upper));
            end = std::min(end, std::max(lower, upper));
        }
        from += start_ / length_ * scaled;
    }
    const Real most = std::min(std::min(ray.tMax * length_, end) - start_, longestWay);
    for (unsigned axis = 0; axis < 3; ++axis) {
        tree.origin[axis] = static_cast<float>(from[static_cast<int>(axis)]);
    }
    tree.tMax = static_cast<float>(most * roundedUp);
}

}  // namespace caustic
