#pragma once

#include "material/delta_bsdf.h"

namespace caustic {

/// Reflects into one direction only, on both sides of the surface.
class MirrorBsdf final : public DeltaBsdf {
public:
    /// @param reflectance  in [0, 1]
    MirrorBsdf(const ShadingFrame& shading, const Color& reflectance) : DeltaBsdf(shading), reflectance_(reflectance) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection; }

private:
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;

    Color reflectance_;
};

}  // namespace caustic
