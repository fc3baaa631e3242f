#include "shape/watertight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/not_implemented.h"
#include "math/double_double.h"
#include "shape/watertight_error.h"

namespace caustic {

namespace {

// a·b - c·d with the sign of the exact value, zero only if that is zero (underflow aside).
Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real ab = a * b;
    const Real cd = c * d;
    if (ab != cd) return ab - cd;
    return std::fma(a, b, -ab) - std::fma(c, d, -cd);
}

Real largest(Real a, Real b, Real c) { return std::max({std::abs(a), std::abs(b), std::abs(c)}); }

// A vertex in the ray's space.
struct Sheared {
    Real x, y, z;
};

Sheared shearedVertex(const ShearedRay& sheared, const Vec3& vertex) {
    const auto [x, y, z] = sheared.axis;
    const Vec3 from = vertex - sheared.ray.origin;
    return {from[x] - sheared.shear.x() * from[z], from[y] - sheared.shear.y() * from[z], from[z]};
}

// The same number in twice the precision: six times the volume that ray origin and triangle span. A shear keeps it.
Real exactNumerator(const ShearedRay& sheared, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto from = [&](const Vec3& p, std::size_t which) {
        const int axis = sheared.axis[which];
        return DoubleDouble::difference(p[axis], sheared.ray.origin[axis]);
    };
    const auto term = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
        return from(p, 2) * (from(r, 0) * from(q, 1) - from(r, 1) * from(q, 0));
    };
    return (term(a, b, c) + term(b, c, a) + term(c, a, b)).high;
}

}  // namespace

std::optional<TriangleHit> intersectWatertight(const ShearedRay& sheared, const Vec3& a, const Vec3& b, const Vec3& c) {
    //! [ex-02.4]
    const auto [ax, ay, az] = shearedVertex(sheared, a);
    const auto [bx, by, bz] = shearedVertex(sheared, b);
    const auto [cx, cy, cz] = shearedVertex(sheared, c);

    // On which side of each edge does the ray, now the z axis, pass? Zero is on both: no edge may let a ray through.
    const Real u = differenceOfProducts(cx, by, cy, bx);
    const Real v = differenceOfProducts(ax, cy, ay, cx);
    const Real w = differenceOfProducts(bx, ay, by, ax);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const Real determinant = u + v + w;
    if (determinant == 0) return std::nullopt;

    Real numerator = u * az + v * bz + w * cz;
    const Real error = watertightError(largest(ax, bx, cx), largest(ay, by, cy), largest(az, bz, cz), largest(u, v, w));
    if (std::abs(numerator) <= error) numerator = exactNumerator(sheared, a, b, c);
    const Real t = sheared.shear.z() * numerator / determinant;
    if (!sheared.ray.reaches(t)) return std::nullopt;
    return TriangleHit{t, v / determinant, w / determinant};
    //! [ex-02.4]
}

}  // namespace caustic
