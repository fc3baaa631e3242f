#pragma once

#include "material/bsdf.h"

namespace caustic {

/// A smooth boundary between two clear media: what Fresnel's equations reflect goes into the mirror direction, the rest
/// is refracted by Snell's law. Nothing is lost. Takes the place of RefractionBsdf, whose shares are fixed.
class DielectricBsdf final : public Bsdf {
public:
    /// The indices are those of the shading frame.
    explicit DielectricBsdf(const ShadingFrame& shading) : Bsdf(shading) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    Color localF(const Vec3&, const Vec3&, Real) const override { return Color::Zero(); }
    Real localPdfW(const Vec3&, const Vec3&, Real) const override { return 0; }
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;
};

}  // namespace caustic
