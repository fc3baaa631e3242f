#include "material/rough_dielectric_material.h"

#include <cmath>

#include "material/dielectric_bsdf.h"
#include "material/ggx.h"
#include "material/rough_dielectric_bsdf.h"
#include "material/roughness.h"

namespace caustic {

RoughDielectricMaterial::RoughDielectricMaterial(Real alphaX, Real alphaY) : alphaX_(alphaX), alphaY_(alphaY) {
    checkRoughness(alphaX, alphaY);
}

void RoughDielectricMaterial::build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const {
    if (looksSmooth(alphaX_, alphaY_) || std::abs(shading.iorBelow - shading.iorAbove) < sameIndex * shading.iorAbove) {
        bsdf.emplace<DielectricBsdf>(shading);
    } else {
        bsdf.emplace<RoughDielectricBsdf>(shading, Ggx(alphaX_, alphaY_));
    }
}

LobeFlags RoughDielectricMaterial::lobes() const {
    const LobeFlags both = LobeFlags::Reflection | LobeFlags::Transmission;
    if (looksSmooth(alphaX_, alphaY_)) return LobeFlags::Delta | both;
    return LobeFlags::Glossy | LobeFlags::Delta | both;  // which of the two, the indices say
}

}  // namespace caustic
