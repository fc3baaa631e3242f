#include "mesh/mesh_space.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace caustic {

namespace {

// A watertight test displaces a ray by less than 8 unit roundoffs of the distance: from 2²⁰ sizes away, 2⁻³⁰.
constexpr Real boxMargin = 0x1p-30;
constexpr Real farthest = 0x1p20;

// No way through the cube [-1, 1]³ is longer than 2√3, and directions are 1 long at least.
constexpr Real longestWay = 4;

// A component of the direction that is smaller counts as this much.
constexpr Real tiniest = 1e-15;

// The largest power of two that is not above x > 0. A mask, because std::ilogb and std::exp2 take longer than a node.
Real powerOfTwoBelow(Real x) {
    constexpr std::uint64_t exponentBits = 0x7ff0000000000000U;
    return std::bit_cast<Real>(std::bit_cast<std::uint64_t>(x) & exponentBits);
}

}  // namespace

MeshSpace::MeshSpace(const Bounds3& box) : center_((box.min() + box.max()) / 2) {
    const Real half = (box.max() - center_).cwiseAbs().cwiseMax((box.min() - center_).cwiseAbs()).maxCoeff();
    scale_ = half > 0 ? std::exp2(-std::ceil(std::log2(half))) : 1;
    const Vec3 margin = Vec3::Constant(boxMargin);
    box_ = {toTree(box.min()) - margin, toTree(box.max()) + margin};
}

MeshRay::MeshRay(const MeshSpace& space, const Ray& ray) {
    const Vec3 origin = space.toTree(ray.origin);
    tooFar_ = !(origin.cwiseAbs().maxCoeff() < farthest);

    // A power of two that makes the largest component one between 1 and 2 does not round, unlike the length.
    const Vec3 scaled = ray.direction * space.scale_;
    length_ = powerOfTwoBelow(scaled.cwiseAbs().maxCoeff());
    const Vec3 direction = scaled / length_;
    Vec3 inverse;
    for (int axis = 0; axis < 3; ++axis) {
        const Real d = direction[axis];
        inverse[axis] = 1 / (std::abs(d) < tiniest ? std::copysign(tiniest, d) : d);
    }

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
        from += start_ * direction;
    }
    const Real most = std::min(std::min(ray.tMax * length_, end) - start_, longestWay);
    for (unsigned axis = 0; axis < 3; ++axis) {
        tree.origin[axis] = static_cast<float>(from[static_cast<int>(axis)]);
        tree.inverse[axis] = static_cast<float>(inverse[static_cast<int>(axis)]);
    }
    tree.tMax = static_cast<float>(most * roundedUp);
}

}  // namespace caustic
