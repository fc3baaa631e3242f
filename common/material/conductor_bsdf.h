#pragma once

#include "material/delta_bsdf.h"
#include "material/metal.h"

namespace caustic {

/// A polished metal: reflects what Fresnel's equations for conductors say into the mirror direction, absorbs the rest.
class ConductorBsdf final : public DeltaBsdf {
public:
    /// @param metal  its index over that of what lies above it
    ConductorBsdf(const ShadingFrame& shading, const Metal& metal) : DeltaBsdf(shading), metal_(metal) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection; }

private:
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;

    Metal metal_;
};

}  // namespace caustic
