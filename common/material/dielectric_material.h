#pragma once

#include "material/material.h"

namespace caustic {

/// Glass, water, whatever is clear and polished: DielectricBsdf. Its index of refraction and its colour are the
/// Interior's of its object.
class DielectricMaterial final : public Material {
public:
    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection | LobeFlags::Transmission; }
};

}  // namespace caustic
