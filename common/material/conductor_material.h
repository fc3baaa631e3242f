#pragma once

#include "material/material.h"
#include "material/metal.h"

namespace caustic {

/// A polished metal of a measured index of refraction: ConductorBsdf. What surrounds it counts: gold under water is
/// redder than gold in air.
class ConductorMaterial final : public Material {
public:
    /// @throws InputError unless n is finite and greater than 0, and k finite and at least 0
    explicit ConductorMaterial(const Metal& metal);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection; }

private:
    Metal metal_;
};

}  // namespace caustic
