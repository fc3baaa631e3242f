#pragma once

#include <memory>

#include "material/material.h"
#include "texture/texture.h"

namespace caustic {

/// Paint, plaster, paper: DiffuseBsdf.
class DiffuseMaterial final : public Material {
public:
    /// @throws InputError unless the reflectance is in [0, 1]
    explicit DiffuseMaterial(const Color& reflectance);
    /// @throws InputError when there is no texture or it leaves [0, 1]
    explicit DiffuseMaterial(std::shared_ptr<const Texture> reflectance);

    void build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const override;
    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Reflection; }
    bool textured() const override { return !reflectance_->constant(); }

private:
    std::shared_ptr<const Texture> reflectance_;
};

}  // namespace caustic
