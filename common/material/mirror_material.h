#pragma once

#include "material/material.h"

namespace caustic {

/// A polished metal, in the report's way: MirrorBsdf with one reflectance for all angles.
class MirrorMaterial final : public Material {
public:
    /// @throws InputError unless the reflectance is in [0, 1]
    explicit MirrorMaterial(const Color& reflectance);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection; }

private:
    Color reflectance_;
};

}  // namespace caustic
