#include "material/refraction_material.h"

#include "material/refraction_bsdf.h"
#include "texture/check_color.h"

namespace caustic {

RefractionMaterial::RefractionMaterial(const Color& reflectance, const Color& transmittance)
    : reflectance_(reflectance), transmittance_(transmittance) {
    checkReflectance(reflectance, "glass's reflectance");
    checkReflectance(transmittance, "glass's transmittance");
    checkReflectance(reflectance + transmittance, "glass's reflectance and transmittance together");
}

void RefractionMaterial::build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    bsdf.emplace<RefractionBsdf>(shading, reflectance_, transmittance_);
}

}  // namespace caustic
