#include "shape/cramer.h"

#include <Eigen/Geometry>

#include "core/not_implemented.h"

namespace caustic {

std::optional<TriangleHit> intersectCramer(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    //! [ex-02.3]
    const Vec3 e1 = b - a;
    const Vec3 e2 = c - a;
    const Vec3 p = ray.direction.cross(e2);
    const Real determinant = p.dot(e1);
    if (determinant == 0) return std::nullopt;

    const Vec3 fromA = ray.origin - a;
    const Real b1 = p.dot(fromA) / determinant;
    if (!(b1 >= 0 && b1 <= 1)) return std::nullopt;

    const Vec3 q = fromA.cross(e1);
    const Real b2 = q.dot(ray.direction) / determinant;
    if (!(b2 >= 0 && b1 + b2 <= 1)) return std::nullopt;

    const Real t = q.dot(e2) / determinant;
    if (!ray.reaches(t)) return std::nullopt;
    return TriangleHit{t, b1, b2};
    //! [ex-02.3]
}

}  // namespace caustic
