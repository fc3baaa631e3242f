#include "shape/watertight.h"

#include <cmath>
#include <utility>

#include "core/not_implemented.h"

namespace caustic {

namespace {

// a·b - c·d with the sign of the exact value, zero only if that is zero (underflow aside).
Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real ab = a * b;
    const Real cd = c * d;
    if (ab != cd) return ab - cd;
    return std::fma(a, b, -ab) - std::fma(c, d, -cd);
}

}  // namespace

ShearedRay::ShearedRay(const Ray& original) : ray(original) {
    int z = 0;
    original.direction.cwiseAbs().maxCoeff(&z);
    axis = {(z + 1) % 3, (z + 2) % 3, z};
    if (original.direction[z] < 0) std::swap(axis[0], axis[1]);
    const Real dz = original.direction[z];
    shear = {original.direction[axis[0]] / dz, original.direction[axis[1]] / dz, 1 / dz};
}

std::optional<TriangleHit> intersectWatertight(const ShearedRay& sheared, const Vec3& a, const Vec3& b, const Vec3& c) {
    //! [ex-02.4]
    const auto [x, y, z] = sheared.axis;
    const Vec3 fromA = a - sheared.ray.origin;
    const Vec3 fromB = b - sheared.ray.origin;
    const Vec3 fromC = c - sheared.ray.origin;
    const Real ax = fromA[x] - sheared.shear.x() * fromA[z];
    const Real ay = fromA[y] - sheared.shear.y() * fromA[z];
    const Real bx = fromB[x] - sheared.shear.x() * fromB[z];
    const Real by = fromB[y] - sheared.shear.y() * fromB[z];
    const Real cx = fromC[x] - sheared.shear.x() * fromC[z];
    const Real cy = fromC[y] - sheared.shear.y() * fromC[z];

    // On which side of each edge does the ray, now the z axis, pass? Zero is on both: no edge may let a ray through.
    const Real u = differenceOfProducts(cx, by, cy, bx);
    const Real v = differenceOfProducts(ax, cy, ay, cx);
    const Real w = differenceOfProducts(bx, ay, by, ax);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const Real determinant = u + v + w;
    if (determinant == 0) return std::nullopt;

    const Real t = sheared.shear.z() * (u * fromA[z] + v * fromB[z] + w * fromC[z]) / determinant;
    if (!sheared.ray.reaches(t)) return std::nullopt;
    return TriangleHit{t, v / determinant, w / determinant};
    //! [ex-02.4]
}

}  // namespace caustic
