#include "material/dielectric_material.h"

#include "material/dielectric_bsdf.h"

namespace caustic {

void DielectricMaterial::build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    bsdf.emplace<DielectricBsdf>(shading);
}

}  // namespace caustic
