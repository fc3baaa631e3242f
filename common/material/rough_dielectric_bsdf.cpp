#include "material/rough_dielectric_bsdf.h"

#include <algorithm>
#include <cmath>

#include "core/not_implemented.h"
#include "material/directions.h"
#include "material/fresnel.h"

namespace caustic {

namespace {

// The normal of the facets that refract wo into wi, above the surface. By Snell's law wo + eta wi has no part along the
// facet. Walter 2007, eq. 16.
Vec3 refractingNormal(const Vec3& wo, const Vec3& wi, Real eta) {
    const Vec3 wm = (wo + eta * wi).normalized();
    return wm.z() < 0 ? -wm : wm;
}

// Solid angle of facet normals per solid angle of the refracted direction: |dwm/dwi|. PBR, 4th ed., eq. 9.36;
// Walter 2007, eq. 17.
Real normalsPerRefracted(const Vec3& wo, const Vec3& wi, const Vec3& wm, Real eta) {
    //! [ex-06.8]
    const Real o = wo.dot(wm);
    const Real i = wi.dot(wm);
    return eta * eta * std::abs(i) / ((o + eta * i) * (o + eta * i));
    //! [ex-06.8]
}

}  // namespace

Color RoughDielectricBsdf::localF(const Vec3& wo, const Vec3& wi, Real eta) const {
    return Color::Constant(value(wo, wi, eta).f);
}

Real RoughDielectricBsdf::localPdfW(const Vec3& wo, const Vec3& wi, Real eta) const { return value(wo, wi, eta).pdfW; }

std::optional<BsdfSample> RoughDielectricBsdf::localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const {
    if (wo.z() <= 0) return std::nullopt;
    const Vec3 wm = facets_.sampleVisible(wo, u);
    const Real cosO = std::clamp(wo.dot(wm), Real(0), Real(1));
    const bool reflects = uLobe < fresnelDielectric(cosO, eta);
    const std::optional<Vec3> wi = reflects ? reflected(wo, wm) : refracted(wo, wm, eta);
    if (!wi || (reflects ? wi->z() <= 0 : wi->z() >= 0)) return std::nullopt;  // towards another facet
    const Value is = value(wo, *wi, eta);
    const LobeFlags lobe = LobeFlags::Glossy | (reflects ? LobeFlags::Reflection : LobeFlags::Transmission);
    return BsdfSample{*wi, Color::Constant(is.f), is.pdfW, reflects ? 1 : eta, lobe};
}

RoughDielectricBsdf::Value RoughDielectricBsdf::value(const Vec3& wo, const Vec3& wi, Real eta) const {
    if (wo.z() <= 0 || wi.z() == 0) return {};
    const bool reflects = wi.z() > 0;
    const Vec3 wm = reflects ? (wo + wi).normalized() : refractingNormal(wo, wi, eta);
    const Real cosO = std::min(wo.dot(wm), Real(1));
    // Both have to be on the side of the facet that they are on of the surface.
    if (cosO <= 0 || (wi.dot(wm) > 0) != reflects) return {};
    const Real reflectance = fresnelDielectric(cosO, eta);
    const Real visible = facets_.pdfVisible(wo, wm);
    if (reflects) {
        // Walter 2007, eq. 20, and PBR, 4th ed., eq. 9.28, for the share of light that is reflected.
        const Real f = reflectance * facets_.D(wm) * facets_.reflectionG(wo, wi) / (4 * wo.z() * wi.z());
        return {f, reflectance * visible / (4 * cosO)};
    }
    const Real density = normalsPerRefracted(wo, wi, wm, eta);
    const Real through = (1 - reflectance) * density;
    // Walter 2007, eq. 21.
    const Real f = through * facets_.D(wm) * facets_.transmissionG(wo, wi) * cosO / (wo.z() * -wi.z());
    return {f, through * visible};
}

}  // namespace caustic
