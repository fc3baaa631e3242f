#include "material/diffuse_material.h"

#include <utility>

#include "core/check.h"
#include "material/diffuse_bsdf.h"
#include "texture/check_color.h"
#include "texture/constant_texture.h"

namespace caustic {

DiffuseMaterial::DiffuseMaterial(const Color& reflectance)
    : DiffuseMaterial(std::make_shared<ConstantTexture>(reflectance)) {}

DiffuseMaterial::DiffuseMaterial(std::shared_ptr<const Texture> reflectance) : reflectance_(std::move(reflectance)) {
    checkArgument(reflectance_ != nullptr, "diffuse material", "", "needs a texture");
    checkReflectance(reflectance_->largest(), "diffuse reflectance");
}

void DiffuseMaterial::build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    bsdf.emplace<DiffuseBsdf>(shading, reflectance_->at(at));
}

}  // namespace caustic
