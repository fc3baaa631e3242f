#pragma once

#include <algorithm>
#include <limits>

#include "material/bsdf.h"

namespace caustic {

/// Phong's model with the factors that keep energy: f = diffuse / π + specular · (n + 2)/(2π) · cosⁿα, where α is
/// the angle between wi and the mirror direction of wo; no highlight where cos α is negative, and 0 for a wi that
/// isn't above the surface. Reciprocal. Source: Phong 1975; Lafortune, Willems 1994, Using the Modified Phong
/// Reflectance Model for Physically Based Rendering, CW 197.
class PhongBsdf final : public Bsdf {
public:
    /// @param diffuse   share reflected into all directions
    /// @param specular  share reflected around the mirror direction at normal incidence; the two sum to at most 1
    /// @param exponent  n, at least 0: the larger, the smaller the highlight
    PhongBsdf(const ShadingFrame& shading, const Color& diffuse, const Color& specular, Real exponent)
        : Bsdf(shading), diffuse_(diffuse), specular_(specular), exponent_(std::max(exponent, leastExponent)) {}

    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Glossy | LobeFlags::Reflection; }

private:
    Color localF(const Vec3& wo, const Vec3& wi, Real eta) const override;
    Real localPdfW(const Vec3& wo, const Vec3& wi, Real eta) const override;
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;
    Real diffuseProbability() const;

    // 0⁰ is 1, which would give an exponent of 0 a highlight beyond the right angle, where no sample goes.
    static constexpr Real leastExponent = std::numeric_limits<Real>::min();

    Color diffuse_;
    Color specular_;
    Real exponent_;
};

}  // namespace caustic
