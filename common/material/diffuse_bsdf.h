#pragma once

#include "material/bsdf.h"

namespace caustic {

/// Reflects alike into all directions: f = reflectance / π, on both sides of the surface. Source: Lambert 1760.
class DiffuseBsdf final : public Bsdf {
public:
    /// @param reflectance  in [0, 1]
    DiffuseBsdf(const ShadingFrame& shading, const Color& reflectance) : Bsdf(shading), reflectance_(reflectance) {}

    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Reflection; }

private:
    Color localF(const Vec3& wo, const Vec3& wi, Real eta) const override;
    Real localPdfW(const Vec3& wo, const Vec3& wi, Real eta) const override;
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;

    Color reflectance_;
};

}  // namespace caustic
