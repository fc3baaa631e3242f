#include "material/rough_conductor_material.h"

#include "material/conductor_bsdf.h"
#include "material/ggx.h"
#include "material/rough_conductor_bsdf.h"
#include "material/roughness.h"

namespace caustic {

RoughConductorMaterial::RoughConductorMaterial(const Metal& metal, Real alphaX, Real alphaY)
    : metal_(metal), alphaX_(alphaX), alphaY_(alphaY) {
    checkMetal(metal);
    checkRoughness(alphaX, alphaY);
}

void RoughConductorMaterial::build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    const Metal inside = metal_.inside(shading.iorAbove);
    if (looksSmooth(alphaX_, alphaY_)) {
        bsdf.emplace<ConductorBsdf>(shading, inside);
    } else {
        bsdf.emplace<RoughConductorBsdf>(shading, inside, Ggx(alphaX_, alphaY_));
    }
}

LobeFlags RoughConductorMaterial::lobes() const {
    return (looksSmooth(alphaX_, alphaY_) ? LobeFlags::Delta : LobeFlags::Glossy) | LobeFlags::Reflection;
}

}  // namespace caustic
