#include "shape/rectangle.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/check.h"

namespace caustic {

Rectangle::Rectangle(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV)
    : corner_(corner), edgeU_(edgeU), edgeV_(edgeV) {
    for (const Real coordinate : corner) checkFinite(coordinate, "rectangle's corner");
    checkPositive(edgeU.norm(), "rectangle's edge's length");
    checkPositive(edgeV.norm(), "rectangle's edge's length");
    const Real cosine = edgeU.dot(edgeV) / (edgeU.norm() * edgeV.norm());
    checkArgument(std::abs(cosine) <= 1e-9, "rectangle's edges", formatReal(cosine), "must be perpendicular");
    const Vec3 normal = edgeU.cross(edgeV);
    area_ = normal.norm();
    checkPositive(area_, "rectangle's area");
    ng_ = normal / area_;
    perU_ = edgeU / edgeU.squaredNorm();
    perV_ = edgeV / edgeV.squaredNorm();
    const Bounds3 box = bounds();
    magnitude_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

std::optional<Hit> Rectangle::intersect(const Ray& ray) const {
    const auto found = find(ray);
    if (!found) return std::nullopt;

    Hit hit;
    static_cast<SurfacePoint&>(hit) = surfacePoint(found->uv);
    hit.t = found->t;
    hit.ns = ng_;
    hit.dpdu = edgeU_;
    hit.dpdv = edgeV_;
    return hit;
}

bool Rectangle::occluded(const Ray& ray) const { return find(ray).has_value(); }

Bounds3 Rectangle::bounds() const {
    Bounds3 box(corner_);
    box.extend(corner_ + edgeU_);
    box.extend(corner_ + edgeV_);
    box.extend(corner_ + edgeU_ + edgeV_);
    return box;
}

std::optional<AreaSample> Rectangle::sampleArea(const Vec2& u) const { return AreaSample{surfacePoint(u), 1 / area_}; }

Real Rectangle::pdfA(const SurfacePoint&) const { return 1 / area_; }

// A ray along the plane has an infinite or NaN t, which no ray reaches.
std::optional<Rectangle::Found> Rectangle::find(const Ray& ray) const {
    const Real t = ng_.dot(corner_ - ray.origin) / ng_.dot(ray.direction);
    if (!ray.reaches(t)) return std::nullopt;
    const Vec3 at = ray.at(t) - corner_;
    const Vec2 uv(at.dot(perU_), at.dot(perV_));
    const bool inside = uv.x() >= 0 && uv.x() <= 1 && uv.y() >= 0 && uv.y() <= 1;
    if (!inside) return std::nullopt;
    return Found{t, uv};
}

SurfacePoint Rectangle::surfacePoint(const Vec2& uv) const {
    return {corner_ + uv.x() * edgeU_ + uv.y() * edgeV_, ng_, uv, magnitude_};
}

}  // namespace caustic
