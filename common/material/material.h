#pragma once

#include "material/bsdf_buffer.h"

namespace caustic {

/// What a surface is made of: makes the BSDF of each of its points. Never changes once it is made.
class Material {
public:
    virtual ~Material() = default;

    /// Makes the BSDF at a point.
    /// @param at       the whole hit: uv for textures; dpdu, dpdv and handedness for what has a direction on the
    /// surface
    /// @param shading  the hit's own frame, which a material may replace
    virtual void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const = 0;

    /// What its BSDFs may do.
    virtual LobeFlags lobes() const = 0;

    /// Whether it varies over the surface.
    virtual bool textured() const { return false; }
};

}  // namespace caustic
