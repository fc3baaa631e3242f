#pragma once

#include "material/delta_bsdf.h"

namespace caustic {

/// A smooth boundary between two clear media: what Fresnel's equations reflect goes into the mirror direction, the rest
/// is refracted by Snell's law. Nothing is lost. Takes the place of RefractionBsdf, whose shares are fixed.
class DielectricBsdf final : public DeltaBsdf {
public:
    /// The indices are those of the shading frame.
    explicit DielectricBsdf(const ShadingFrame& shading) : DeltaBsdf(shading) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    // Shares of the energy, each as f and as pdfW, eta as BsdfSample says. A lobe without a share is left out; there
    // is none when wo.z < 0.
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;
};

}  // namespace caustic
