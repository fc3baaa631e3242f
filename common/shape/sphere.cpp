#include "shape/sphere.h"

#include <cmath>
#include <numbers>

#include "core/check.h"
#include "shape/ball.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// u and v of a unit vector from the centre.
Vec2 parameters(const Vec3& n) {
    const Real angle = std::atan2(-n.z(), n.x());
    const Real u = angle < 0 ? angle / (2 * pi) + 1 : angle / (2 * pi);
    return {u, std::atan2(std::hypot(n.x(), n.z()), -n.y()) / pi};
}

}  // namespace

Sphere::Sphere(const Vec3& center, Real radius) : center_(center), radius_(radius) {
    for (const Real coordinate : center) checkFinite(coordinate, "sphere's centre");
    checkPositive(radius, "sphere's radius");
    magnitude_ = center.cwiseAbs().maxCoeff() + radius;
}

std::optional<Hit> Sphere::intersect(const Ray& ray) const {
    const std::optional<Real> t = nearestT(ray);
    if (!t) return std::nullopt;

    Hit hit;
    const Vec3 n = (ray.at(*t) - center_).normalized();
    static_cast<SurfacePoint&>(hit) = surfacePoint(n);
    hit.t = *t;
    hit.ns = n;
    const Real aroundAxis = std::hypot(n.x(), n.z());
    const Real cosU = aroundAxis > 0 ? n.x() / aroundAxis : 1;
    const Real sinU = aroundAxis > 0 ? -n.z() / aroundAxis : 0;
    hit.dpdu = 2 * pi * radius_ * Vec3(n.z(), 0, -n.x());
    hit.dpdv = pi * radius_ * Vec3(-n.y() * cosU, aroundAxis, n.y() * sinU);
    return hit;
}

bool Sphere::occluded(const Ray& ray) const { return nearestT(ray).has_value(); }

Bounds3 Sphere::bounds() const { return {center_.array() - radius_, center_.array() + radius_}; }

std::optional<AreaSample> Sphere::sampleArea(const Vec2& u) const {
    // Archimedes: equal slices of the axis cut equal areas off the sphere.
    const Real y = 2 * u.y() - 1;
    const Real aroundAxis = std::sqrt(1 - y * y);
    const Real angle = 2 * pi * u.x();
    const SurfacePoint at = surfacePoint({aroundAxis * std::cos(angle), y, -aroundAxis * std::sin(angle)});
    return AreaSample{at, pdfA(at)};
}

Real Sphere::pdfA(const SurfacePoint&) const { return 1 / (4 * pi * radius_ * radius_); }

std::optional<Real> Sphere::nearestT(const Ray& ray) const {
    const Interval inside = ballInterval<Real, 3>(center_ - ray.origin, ray.direction, radius_);
    if (ray.reaches(inside.lower)) return inside.lower;
    if (ray.reaches(inside.upper)) return inside.upper;
    return std::nullopt;
}

SurfacePoint Sphere::surfacePoint(const Vec3& outward) const {
    return {center_ + radius_ * outward, outward, parameters(outward), magnitude_};
}

}  // namespace caustic
