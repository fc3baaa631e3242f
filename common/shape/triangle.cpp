#include "shape/triangle.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/check.h"
#include "shape/watertight.h"

namespace caustic {

Triangle::Triangle(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c) {
    for (const Vec3& vertex : {a, b, c}) {
        for (const Real coordinate : vertex) checkFinite(coordinate, "triangle's vertex");
    }
    const Vec3 twiceArea = (b - a).cross(c - a);
    area_ = twiceArea.norm() / 2;
    checkPositive(area_, "triangle's area");
    ng_ = twiceArea / (2 * area_);
    magnitude_ = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs()).maxCoeff();
}

std::optional<Hit> Triangle::intersect(const Ray& ray) const {
    const std::optional<TriangleHit> found = intersectWatertight(ShearedRay(ray), a_, b_, c_);
    if (!found) return std::nullopt;

    Hit hit;
    static_cast<SurfacePoint&>(hit) = surfacePoint({found->b1, found->b2});
    hit.t = found->t;
    hit.ns = ng_;
    hit.dpdu = b_ - a_;
    hit.dpdv = c_ - a_;
    return hit;
}

bool Triangle::occluded(const Ray& ray) const { return intersectWatertight(ShearedRay(ray), a_, b_, c_).has_value(); }

Bounds3 Triangle::bounds() const {
    Bounds3 box(a_);
    box.extend(b_);
    box.extend(c_);
    return box;
}

std::optional<AreaSample> Triangle::sampleArea(const Vec2& u) const {
    // A triangle similar to the whole one, at the vertex a, has the share u.x of the area when its size is √u.x.
    const Real size = std::sqrt(u.x());
    const SurfacePoint at = surfacePoint({size * (1 - u.y()), size * u.y()});
    return AreaSample{at, pdfA(at)};
}

Real Triangle::pdfA(const SurfacePoint&) const { return 1 / area_; }

SurfacePoint Triangle::surfacePoint(const Vec2& uv) const {
    return {(1 - uv.x() - uv.y()) * a_ + uv.x() * b_ + uv.y() * c_, ng_, uv, magnitude_};
}

}  // namespace caustic
