#include "texture/mapped_normal.h"

#include <algorithm>
#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

namespace {

// The least cosine between ng and a mirrored direction; closer to the surface, half of wo's own.
constexpr Real leastCosine = 0.01;

}  // namespace

Vec3 mappedNormal(const Hit& at, const Vec3& local, const Vec3& wo) {
    //! [ex-11.3]
    const Vec3 along = at.dpdu - at.dpdu.dot(at.ns) * at.ns;
    if (local == Vec3::UnitZ() || !(along.norm() > 1e-8 * at.dpdu.norm())) return at.ns;
    const Vec3 s = along.normalized();
    const Vec3 t = at.handedness() * at.ns.cross(s);
    const Vec3 normal = (local.x() * s + local.y() * t + local.z() * at.ns).normalized();

    // In the plane of ng and the normal, at the angle β from ng, a normal mirrors wo to the cosine
    // cosO cos 2β + sinO sin 2β = m cos(2β − δ).
    const Vec3 e = (normal - normal.dot(at.ng) * at.ng).normalized();
    const Real side = wo.dot(at.ng) >= 0 ? 1 : -1;
    const Real cosO = side * wo.dot(at.ng);
    const Real sinO = side * wo.dot(e);
    const Real m = std::hypot(cosO, sinO);
    if (!(m > 0)) return normal;
    const Real most = (std::atan2(sinO, cosO) + std::acos(std::min(leastCosine, cosO / 2) / m)) / 2;
    if (std::atan2(normal.dot(e), normal.dot(at.ng)) <= most) return normal;
    return std::cos(most) * at.ng + std::sin(most) * e;
    //! [ex-11.3]
}

}  // namespace caustic
