#include "shape/box.h"

#include <cmath>

#include "core/check.h"
#include "math/slabs.h"

namespace caustic {

namespace {

// The axes along which u and v of a face run. On a low face they swap, so that u × v points outwards on both.
int axisU(int axis, bool high) { return (axis + (high ? 1 : 2)) % 3; }
int axisV(int axis, bool high) { return (axis + (high ? 2 : 1)) % 3; }

}  // namespace

Box::Box(const Vec3& low, const Vec3& high) : box_(low, high) {
    for (int axis = 0; axis < 3; ++axis) {
        checkFinite(low[axis], "box's low corner");
        checkFinite(high[axis], "box's high corner");
        checkPositive(high[axis] - low[axis], "box's extent");
    }
    magnitude_ = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
}

std::optional<Hit> Box::intersect(const Ray& ray) const {
    const std::optional<Real> t = nearestT(ray);
    if (!t) return std::nullopt;

    const Face face = faceAt(ray, *t);
    Hit hit;
    static_cast<SurfacePoint&>(hit) = surfacePoint(face, ray.at(*t));
    hit.t = *t;
    hit.ns = hit.ng;
    const int u = axisU(face.axis, face.high);
    const int v = axisV(face.axis, face.high);
    hit.dpdu = Vec3::Unit(u) * box_.sizes()[u];
    hit.dpdv = Vec3::Unit(v) * box_.sizes()[v];
    return hit;
}

bool Box::occluded(const Ray& ray) const { return nearestT(ray).has_value(); }

std::optional<AreaSample> Box::sampleArea(const Vec2& u) const {
    const Vec3 areas(faceArea(0), faceArea(1), faceArea(2));
    // u.x chooses one of six faces by area; what is left of it is uniform within the face.
    Real rest = u.x() * 2 * areas.sum();
    int face = 0;
    while (face < 5 && rest >= areas[face / 2]) rest -= areas[face++ / 2];
    const int axis = face / 2;
    const bool high = face % 2 == 1;
    const Vec2 uv(std::min(rest / areas[axis], Real(1)), u.y());
    Vec3 point = box_.min();
    point[axisU(axis, high)] += uv.x() * box_.sizes()[axisU(axis, high)];
    point[axisV(axis, high)] += uv.y() * box_.sizes()[axisV(axis, high)];
    const SurfacePoint at = surfacePoint({axis, high}, point);
    return AreaSample{at, pdfA(at)};
}

Real Box::pdfA(const SurfacePoint&) const { return 1 / (2 * (faceArea(0) + faceArea(1) + faceArea(2))); }

std::optional<Real> Box::nearestT(const Ray& ray) const {
    const Interval inside = slabInterval(box_, ray);
    if (inside.empty()) return std::nullopt;
    const Real t = ray.reaches(inside.lower) ? inside.lower : inside.upper;
    // Slabs take no notice of NaN. A ray with one must not be lost in a box as if nothing were wrong.
    if (!ray.reaches(t) || !ray.at(t).allFinite()) return std::nullopt;
    return t;
}

// The face whose plane the ray crosses closest to t, the rounding of slabInterval aside.
Box::Face Box::faceAt(const Ray& ray, Real t) const {
    Face nearest = {0, false};
    Real least = std::numeric_limits<Real>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            const Real plane = high ? box_.max()[axis] : box_.min()[axis];
            const Real distance = std::abs((plane - ray.origin[axis]) * (1 / ray.direction[axis]) - t);
            if (distance < least) {
                least = distance;
                nearest = {axis, high};
            }
        }
    }
    return nearest;
}

SurfacePoint Box::surfacePoint(Face face, const Vec3& point) const {
    Vec3 at = point.cwiseMax(box_.min()).cwiseMin(box_.max());
    at[face.axis] = face.high ? box_.max()[face.axis] : box_.min()[face.axis];
    const Vec3 shares = (at - box_.min()).cwiseQuotient(box_.sizes());
    const Vec2 uv(shares[axisU(face.axis, face.high)], shares[axisV(face.axis, face.high)]);
    return {at, Vec3::Unit(face.axis) * (face.high ? 1 : -1), uv, magnitude_};
}

Real Box::faceArea(int axis) const { return box_.sizes()[(axis + 1) % 3] * box_.sizes()[(axis + 2) % 3]; }

}  // namespace caustic
