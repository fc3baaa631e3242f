#pragma once

#include "material/delta_bsdf.h"

namespace caustic {

/// A smooth boundary in the report's way: a fixed share of the light is refracted by Snell's law and a fixed share is
/// reflected, whatever the angle. Beyond the critical angle all of it is reflected. Chapter 06 lets the angle decide.
class RefractionBsdf final : public DeltaBsdf {
public:
    /// @param reflectance    share that is reflected
    /// @param transmittance  share that is refracted; the two sum to at most 1
    RefractionBsdf(const ShadingFrame& shading, const Color& reflectance, const Color& transmittance)
        : DeltaBsdf(shading), reflectance_(reflectance), transmittance_(transmittance) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;

    Color reflectance_;
    Color transmittance_;
};

}  // namespace caustic
