#include "shape/mesh_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace caustic {

namespace {

// A watertight test displaces a ray by less than 8 unit roundoffs of the distance: from 2²⁰ sizes away, 2⁻³⁰.
constexpr Real boxMargin = 0x1p-30;
constexpr Real farthest = 0x1p20;

// No way through the cube [-1, 1]³ is longer than 2√3.
constexpr float longestWay = 4;

}  // namespace

MeshSpace::MeshSpace(const Bounds3& box) : center_((box.min() + box.max()) / 2) {
    const Real half = (box.max() - center_).cwiseAbs().cwiseMax((box.min() - center_).cwiseAbs()).maxCoeff();
    scale_ = half > 0 ? std::exp2(-std::ceil(std::log2(half))) : 1;
    const Vec3 lower = toTree(box.min());
    const Vec3 upper = toTree(box.max());
    radius_ = lower.cwiseAbs().cwiseMax(upper.cwiseAbs()).norm();
    box_ = {lower - Vec3::Constant(boxMargin), upper + Vec3::Constant(boxMargin)};
}

bool MeshRay::comesFromTooFar(const MeshSpace& space, const Ray& ray) {
    return !(space.toTree(ray.origin).cwiseAbs().maxCoeff() < farthest);
}

std::optional<MeshRay> MeshRay::through(const MeshSpace& space, const Ray& ray) {
    const Vec3 origin = space.toTree(ray.origin);
    const Vec3 direction = ray.direction * space.scale_;
    const Real length = direction.norm();
    const Vec3 unit = direction / length;
    Real start = ray.tMin * length;
    if (start != 0 || !space.box_.contains(origin)) {
        Real end = std::numeric_limits<Real>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const Real lower = (space.box_.min()[axis] - origin[axis]) / unit[axis];
            const Real upper = (space.box_.max()[axis] - origin[axis]) / unit[axis];
            // The second argument is never NaN; std::max and std::min return the first when the comparison fails.
            start = std::max(start, std::min(lower, upper));
            end = std::min(end, std::max(lower, upper));
        }
        if (!(start <= end)) return std::nullopt;
    }
    const Vec3 from = origin + start * unit;
    const auto narrow = [](const Vec3& v) {
        return std::array{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    };
    const Real most = std::min<Real>((ray.tMax * length - start) * (1 + 1e-6), longestWay);
    if (!(most >= 0)) return std::nullopt;
    return MeshRay(TreeRay(narrow(from), narrow(unit), static_cast<float>(most)), length, start);
}

}  // namespace caustic
