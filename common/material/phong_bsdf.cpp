#include "material/phong_bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/not_implemented.h"
#include "material/directions.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// cos α between wi and the mirror direction of wo, at least 0.
Real highlightCosine(const Vec3& wo, const Vec3& wi) { return std::max(Real(0), reflected(wo, Vec3::UnitZ()).dot(wi)); }

}  // namespace

Color PhongBsdf::localF(const Vec3& wo, const Vec3& wi, Real) const {
    //! [ex-05.4]
    if (wi.z() <= 0) return Color::Zero();
    // Lafortune, Willems 1994: with this factor the lobe reflects no more than `specular_`.
    const Real highlight = (exponent_ + 2) / (2 * pi) * std::pow(highlightCosine(wo, wi), exponent_);
    return diffuse_ / pi + specular_ * highlight;
    //! [ex-05.4]
}

Real PhongBsdf::localPdfW(const Vec3& wo, const Vec3& wi, Real) const {
    if (wi.z() <= 0) return 0;
    const Real diffuse = diffuseProbability();
    // Lafortune, Willems 1994: the density of powerHemisphere around the mirror direction.
    const Real highlight = (exponent_ + 1) / (2 * pi) * std::pow(highlightCosine(wo, wi), exponent_);
    // Each lobe by the chance that it is picked; the diffuse one by PBR, 4th ed., A.5.3.
    return diffuse * wi.z() / pi + (1 - diffuse) * highlight;
}

std::optional<BsdfSample> PhongBsdf::localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const {
    const bool diffuse = uLobe < diffuseProbability();
    const Frame aroundMirror = Frame::around(reflected(wo, Vec3::UnitZ()));
    const Vec3 wi = diffuse ? cosineHemisphere(u) : aroundMirror.toWorld(powerHemisphere(u, exponent_));
    if (wi.z() <= 0) return std::nullopt;
    const LobeFlags lobe = (diffuse ? LobeFlags::Diffuse : LobeFlags::Glossy) | LobeFlags::Reflection;
    return BsdfSample{wi, localF(wo, wi, eta), localPdfW(wo, wi, eta), 1, lobe};
}

// In proportion to the lobes' energy; a black surface samples its diffuse lobe of 0.
Real PhongBsdf::diffuseProbability() const {
    const Real all = diffuse_.maxCoeff() + specular_.maxCoeff();
    return all > 0 ? diffuse_.maxCoeff() / all : 1;
}

}  // namespace caustic
