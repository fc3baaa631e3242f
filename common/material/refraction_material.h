#pragma once

#include "material/material.h"

namespace caustic {

/// Clear glass or water in the report's way: RefractionBsdf. Its index of refraction is that of its object's Interior.
class RefractionMaterial final : public Material {
public:
    /// @param reflectance    share that is reflected at every angle
    /// @param transmittance  share that is refracted
    /// @throws InputError unless both are in [0, 1] and sum to at most 1
    RefractionMaterial(const Color& reflectance, const Color& transmittance);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    Color reflectance_;
    Color transmittance_;
};

}  // namespace caustic
