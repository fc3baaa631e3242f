#pragma once

#include <memory>

#include "material/material.h"
#include "texture/texture.h"

namespace caustic {

/// A diffuse surface with a highlight, the report's local model: PhongBsdf.
class PhongMaterial final : public Material {
public:
    /// @param diffuse   share reflected into all directions
    /// @param specular  share reflected around the mirror direction
    /// @param exponent  of the cosine, at least 0
    /// @throws InputError when there is no texture, a share is negative, the two sum to more than 1 somewhere, or the
    ///         exponent isn't finite and at least 0
    PhongMaterial(std::shared_ptr<const Texture> diffuse, const Color& specular, Real exponent);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Glossy | LobeFlags::Reflection; }
    bool textured() const override { return !diffuse_->constant(); }

private:
    std::shared_ptr<const Texture> diffuse_;
    Color specular_;
    Real exponent_;
};

}  // namespace caustic
