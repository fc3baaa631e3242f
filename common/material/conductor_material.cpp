#include "material/conductor_material.h"

#include "material/conductor_bsdf.h"

namespace caustic {

ConductorMaterial::ConductorMaterial(const Metal& metal) : metal_(metal) { checkMetal(metal); }

void ConductorMaterial::build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    bsdf.emplace<ConductorBsdf>(shading, metal_.inside(shading.iorAbove));
}

}  // namespace caustic
