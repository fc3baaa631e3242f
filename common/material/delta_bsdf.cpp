#include "material/delta_bsdf.h"

namespace caustic {

std::optional<BsdfSample> DeltaBsdf::localSample(const Vec3& wo, const Vec2&, Real uLobe, Real eta) const {
    Real upTo = 0;
    for (const BsdfSample& one : localDeltaLobes(wo, eta)) {
        upTo += one.pdfW;
        if (uLobe < upTo) return one;
    }
    return std::nullopt;
}

}  // namespace caustic
