#pragma once

#include "material/material.h"
#include "material/metal.h"

namespace caustic {

/// A metal that is brushed, blasted or cast: RoughConductorBsdf, or ConductorBsdf when it is too smooth to tell.
class RoughConductorMaterial final : public Material {
public:
    /// @param alphaX  roughness along dpdu, in [0, 1]
    /// @param alphaY  across it, in [0, 1]; the same for a metal that looks alike however it is turned
    /// @throws InputError unless the metal's n is finite and greater than 0, its k finite and at least 0, and both
    ///         roughnesses are in [0, 1]
    RoughConductorMaterial(const Metal& metal, Real alphaX, Real alphaY);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override;

private:
    Metal metal_;
    Real alphaX_;
    Real alphaY_;
};

}  // namespace caustic
