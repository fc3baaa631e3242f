#pragma once

#include "material/bsdf.h"

namespace caustic {

/// Reflects into one direction only, on both sides of the surface.
class MirrorBsdf final : public Bsdf {
public:
    /// @param reflectance  in [0, 1]
    MirrorBsdf(const ShadingFrame& shading, const Color& reflectance) : Bsdf(shading), reflectance_(reflectance) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection; }

private:
    Color localF(const Vec3&, const Vec3&, Real) const override { return Color::Zero(); }
    Real localPdfW(const Vec3&, const Vec3&, Real) const override { return 0; }
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;

    Color reflectance_;
};

}  // namespace caustic
