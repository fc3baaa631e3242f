#include "accel/kd_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace caustic {

namespace {

// A direction's component that is smaller than this share of the largest counts as this much: over the way to the box
// that moves the ray by far less than the slack.
constexpr Real tiniestShare = 1e-30;

// Unit roundoffs of the farthest coordinate, seen from the ray's origin, by which a test may displace the ray: 5 by the
// watertight triangle's shear, 3 by a crossing; the rest is room for shapes of other kinds.
constexpr Real displacement = 32 * std::numeric_limits<Real>::epsilon() / 2;

}  // namespace

KdRay::KdRay(const Ray& ray, const Bounds3& box) : origin(ray.origin), tNear(ray.tMin), tFar(ray.tMax) {
    if (ray.origin.hasNaN() || ray.direction.hasNaN()) tFar = -std::numeric_limits<Real>::infinity();
    const Real largest = ray.direction.cwiseAbs().maxCoeff();
    const Vec3 reach = (box.min() - origin).cwiseAbs().cwiseMax((box.max() - origin).cwiseAbs());
    const Real displaced = displacement * reach.maxCoeff();
    for (int axis = 0; axis < 3; ++axis) {
        const Real component = ray.direction[axis];
        const Real safe = std::abs(component) >= tiniestShare * largest
                              ? component
                              : std::copysign(tiniestShare * largest, component);
        inverse[axis] = 1 / safe;
        slack[axis] = displaced * std::abs(inverse[axis]);
        const Real lower = (box.min()[axis] - origin[axis]) * inverse[axis];
        const Real upper = (box.max()[axis] - origin[axis]) * inverse[axis];
        tNear = std::max(tNear, std::min(lower, upper) - slack[axis]);
        tFar = std::min(tFar, std::max(lower, upper) + slack[axis]);
    }
}

KdTree::KdTree(std::vector<Bounds3> boxes, const KdRule& rule, const KdClip<Real>& clip)
    : tree_(buildKdTree<Real>(std::move(boxes), rule, clip)) {}

std::size_t KdTree::memory() const {
    return tree_.nodes.size() * sizeof(tree_.nodes[0]) + tree_.items.size() * sizeof(tree_.items[0]);
}

}  // namespace caustic
