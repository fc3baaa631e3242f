#include "material/rough_conductor_bsdf.h"

#include <algorithm>

#include "core/not_implemented.h"
#include "material/directions.h"
#include "material/fresnel.h"

namespace caustic {

Color RoughConductorBsdf::localF(const Vec3& wo, const Vec3& wi, Real) const {
    //! [ex-06.7]
    if (wo.z() <= 0 || wi.z() <= 0) return Color::Zero();
    const Vec3 wm = (wo + wi).normalized();
    const Color reflectance = fresnelConductor(std::min(wo.dot(wm), Real(1)), metal_.eta, metal_.k);
    // Walter 2007, eq. 20.
    return reflectance * facets_.D(wm) * facets_.reflectionG(wo, wi) / (4 * wo.z() * wi.z());
    //! [ex-06.7]
}

Real RoughConductorBsdf::localPdfW(const Vec3& wo, const Vec3& wi, Real) const {
    if (wo.z() <= 0 || wi.z() <= 0) return 0;
    const Vec3 wm = (wo + wi).normalized();
    // PBR, 4th ed., eq. 9.28. Turning wm by an angle turns wi by twice that: the density of wi is 1/(4 wo · wm) times
    // that of wm.
    return facets_.pdfVisible(wo, wm) / (4 * wo.dot(wm));
}

std::optional<BsdfSample> RoughConductorBsdf::localSample(const Vec3& wo, const Vec2& u, Real, Real eta) const {
    if (wo.z() <= 0) return std::nullopt;
    const Vec3 wi = reflected(wo, facets_.sampleVisible(wo, u));
    if (wi.z() <= 0) return std::nullopt;  // towards another facet
    return BsdfSample{wi, localF(wo, wi, eta), localPdfW(wo, wi, eta), 1, lobes()};
}

}  // namespace caustic
