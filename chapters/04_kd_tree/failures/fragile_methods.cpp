#include "failures/fragile_methods.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "shape/watertight.h"

namespace caustic {

namespace {

enum class Stop { FirstCell, BestHit };

// The textbook's recursion: the side of the origin first, and the crossing decides about the other.
class Descent {
public:
    Descent(const KdTree& tree, const MeshData& mesh, const std::vector<std::uint32_t>& triangles, const Ray& ray,
            Stop stop)
        : tree_(tree.nodes()), mesh_(mesh), triangles_(triangles), sheared_(ray), stop_(stop) {}

    std::optional<MeshHit> run() {
        Real tNear = sheared_.ray.tMin;
        Real tFar = sheared_.ray.tMax;
        for (int axis = 0; axis < 3; ++axis) {
            Real enter = (tree_.box.min()[axis] - sheared_.ray.origin[axis]) / sheared_.ray.direction[axis];
            Real leave = (tree_.box.max()[axis] - sheared_.ray.origin[axis]) / sheared_.ray.direction[axis];
            if (enter > leave) std::swap(enter, leave);
            tNear = enter > tNear ? enter : tNear;
            tFar = leave < tFar ? leave : tFar;
        }
        if (tNear <= tFar) visit(0, tNear, tFar);
        return nearest_;
    }

private:
    // Returns whether the search is over.
    bool visit(std::uint32_t index, Real tNear, Real tFar) {
        const KdNode<Real>& node = tree_.nodes[index];
        if (node.isLeaf()) return visitLeaf(node);
        const Real origin = sheared_.ray.origin[node.axis];
        const Real direction = sheared_.ray.direction[node.axis];
        const Real crossing = (node.plane - origin) / direction;
        const bool lowerFirst = origin < node.plane || (origin == node.plane && direction <= 0);
        const std::uint32_t nearer = lowerFirst ? node.first : node.first + 1;
        const std::uint32_t farther = lowerFirst ? node.first + 1 : node.first;
        if (crossing > tFar || crossing <= 0) return visit(nearer, tNear, tFar);
        if (crossing < tNear) return visit(farther, tNear, tFar);
        if (visit(nearer, tNear, crossing)) return true;
        if (nearest_ && nearest_->t < crossing) return true;
        return visit(farther, crossing, tFar);
    }

    bool visitLeaf(const KdNode<Real>& node) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const std::uint32_t triangle = triangles_[tree_.items[i]];
            const auto [a, b, c] = mesh_.corners(triangle);
            const auto found = intersectWatertight(sheared_, a, b, c);
            if (!found) continue;
            sheared_.ray.tMax = found->t;
            nearest_ = MeshHit{*found, triangle};
        }
        return stop_ == Stop::FirstCell && nearest_.has_value();
    }

    const KdNodes<Real>& tree_;
    const MeshData& mesh_;
    const std::vector<std::uint32_t>& triangles_;
    ShearedRay sheared_;
    Stop stop_;
    std::optional<MeshHit> nearest_;
};

}  // namespace

std::optional<MeshHit> intersectFirstCell(const KdTree& tree, const MeshData& mesh,
                                          const std::vector<std::uint32_t>& triangles, const Ray& ray) {
    return Descent(tree, mesh, triangles, ray, Stop::FirstCell).run();
}

std::optional<MeshHit> intersectWithoutSlack(const KdTree& tree, const MeshData& mesh,
                                             const std::vector<std::uint32_t>& triangles, const Ray& ray) {
    return Descent(tree, mesh, triangles, ray, Stop::BestHit).run();
}

std::optional<MeshHit> intersectFloat(const MeshData& mesh, const Ray& ray) {
    using Vec3f = Eigen::Vector3f;
    const Vec3f origin = ray.origin.cast<float>();
    const Vec3f direction = ray.direction.cast<float>();
    std::optional<MeshHit> nearest;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto [a, b, c] = mesh.corners(triangle);
        const Vec3f e1 = b.cast<float>() - a.cast<float>();
        const Vec3f e2 = c.cast<float>() - a.cast<float>();
        const Vec3f p = direction.cross(e2);
        const float determinant = p.dot(e1);
        if (determinant == 0) continue;
        const Vec3f from = origin - a.cast<float>();
        const Vec3f q = from.cross(e1);
        const float b1 = p.dot(from) / determinant;
        const float b2 = q.dot(direction) / determinant;
        const auto t = Real{q.dot(e2) / determinant};
        if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1) || !ray.reaches(t) || (nearest && t >= nearest->t)) continue;
        nearest = MeshHit{{t, Real{b1}, Real{b2}}, triangle};
    }
    return nearest;
}

}  // namespace caustic
