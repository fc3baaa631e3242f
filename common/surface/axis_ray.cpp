#include "surface/axis_ray.h"

#include <cmath>

namespace caustic {

AxisRay::AxisRay(const Ray& ray, Real middle) {
    const Vec3& o = ray.origin;
    tPerLength = 1 / ray.direction.norm();
    const Vec3 d = ray.direction * tPerLength;
    rise = d.y();
    perRise = 1 / rise;
    across = Vec2(d.x(), d.z());
    flatSquare = across.squaredNorm();
    flat = std::sqrt(flatSquare);
    leaning = flatSquare >= Real(0.5);

    const Vec2 origin(o.x(), o.z());
    if (leaning) {
        const Real s = -origin.dot(across) / flatSquare;
        // The distance from the axis as a cross product: the squares of a far origin would cancel.
        const Real aside = (origin.x() * across.y() - origin.y() * across.x()) / flatSquare;
        base = aside * Vec2(across.y(), -across.x());
        baseHeight = o.y() + s * rise;
        drift = 0;
        near = std::abs(aside) * flat;
        nearest = 0;
        tBase = s * tPerLength;
        return;
    }
    const Real s = (middle - o.y()) / rise;
    base = origin + s * across;
    baseHeight = middle;
    drift = base.dot(across);
    near = base.norm();
    nearest = flatSquare > 0 ? -drift / flatSquare : 0;
    tBase = s * tPerLength;
}

}  // namespace caustic
