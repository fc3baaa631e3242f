#include "shape/plane.h"

#include <algorithm>
#include <limits>

#include "core/check.h"

namespace caustic {

Plane::Plane(const Vec3& point, const Vec3& normal) : point_(point) {
    for (const Real coordinate : point) checkFinite(coordinate, "plane's point");
    checkPositive(normal.norm(), "plane's normal's length");
    frame_ = Frame::around(normal.normalized());
}

std::optional<Hit> Plane::intersect(const Ray& ray) const {
    const Real t = crossing(ray);
    if (!ray.reaches(t)) return std::nullopt;

    Hit hit;
    const Vec3 rounded = ray.at(t);
    hit.point = rounded - frame_.n.dot(rounded - point_) * frame_.n;
    hit.ng = frame_.n;
    const Vec3 local = frame_.toLocal(hit.point - point_);
    hit.uv = {local.x(), local.y()};
    hit.magnitude = std::max(hit.point.cwiseAbs().maxCoeff(), point_.cwiseAbs().maxCoeff());
    hit.t = t;
    hit.ns = frame_.n;
    hit.dpdu = frame_.s;
    hit.dpdv = frame_.t;
    return hit;
}

bool Plane::occluded(const Ray& ray) const { return ray.reaches(crossing(ray)); }

Bounds3 Plane::bounds() const {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    return {Vec3::Constant(-infinity), Vec3::Constant(infinity)};
}

// Infinite or NaN for a ray along the plane: no t that a ray reaches.
Real Plane::crossing(const Ray& ray) const { return frame_.n.dot(point_ - ray.origin) / frame_.n.dot(ray.direction); }

}  // namespace caustic
