#include "material/diffuse_bsdf.h"

#include <numbers>

#include "sampling/warp.h"

namespace caustic {

Color DiffuseBsdf::localF(const Vec3&, const Vec3& wi, Real) const {
    if (wi.z() <= 0) return Color::Zero();
    // PBR, 4th ed., 9.2: the same into all directions.
    return reflectance_ * std::numbers::inv_pi;
}

Real DiffuseBsdf::localPdfW(const Vec3&, const Vec3& wi, Real) const {
    // PBR, 4th ed., A.5.3: the density of cosineHemisphere.
    return wi.z() > 0 ? wi.z() * std::numbers::inv_pi : 0;
}

std::optional<BsdfSample> DiffuseBsdf::localSample(const Vec3& wo, const Vec2& u, Real, Real eta) const {
    const Vec3 wi = cosineHemisphere(u);
    return BsdfSample{wi, localF(wo, wi, eta), localPdfW(wo, wi, eta), 1, lobes()};
}

}  // namespace caustic
