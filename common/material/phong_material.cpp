#include "material/phong_material.h"

#include <utility>

#include "core/check.h"
#include "material/phong_bsdf.h"
#include "texture/check_color.h"

namespace caustic {

PhongMaterial::PhongMaterial(std::shared_ptr<const Texture> diffuse, const Color& specular, Real exponent)
    : diffuse_(std::move(diffuse)), specular_(specular), exponent_(exponent) {
    checkArgument(diffuse_ != nullptr, "Phong material", "", "needs a texture");
    checkReflectance(specular, "Phong material's specular share");
    checkReflectance(diffuse_->largest() + specular, "Phong material's shares together");
    checkFinite(exponent, "Phong exponent");
    checkArgument(exponent >= 0, "Phong exponent", formatReal(exponent), "must be at least 0");
}

void PhongMaterial::build(const Hit& at, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    bsdf.emplace<PhongBsdf>(shading, diffuse_->at(at), specular_, exponent_);
}

}  // namespace caustic
