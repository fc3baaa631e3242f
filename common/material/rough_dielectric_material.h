#pragma once

#include "material/material.h"

namespace caustic {

/// Ground or etched glass: RoughDielectricBsdf. It is DielectricBsdf where it is too smooth to tell, and where the
/// indices on both sides are so close that light passes straight on. Index and colour are the Interior's of its object.
class RoughDielectricMaterial final : public Material {
public:
    /// Relative indices closer to 1 than this bend light by less than 0.006 degrees at a facet of 45 degrees.
    static constexpr Real sameIndex = 1e-4;

    /// @param alphaX  roughness along dpdu, in [0, 1]
    /// @param alphaY  across it, in [0, 1]; the same for glass that looks alike however it is turned
    /// @throws InputError unless both are in [0, 1]
    RoughDielectricMaterial(Real alphaX, Real alphaY);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override;

private:
    Real alphaX_;
    Real alphaY_;
};

}  // namespace caustic
