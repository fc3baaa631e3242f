#include "material/mirror_material.h"

#include "material/mirror_bsdf.h"
#include "texture/check_color.h"

namespace caustic {

MirrorMaterial::MirrorMaterial(const Color& reflectance) : reflectance_(reflectance) {
    checkReflectance(reflectance, "mirror's reflectance");
}

void MirrorMaterial::build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    bsdf.emplace<MirrorBsdf>(shading, reflectance_);
}

}  // namespace caustic
