#include "material/mirror_bsdf.h"

#include "material/directions.h"

namespace caustic {

DeltaLobes MirrorBsdf::localDeltaLobes(const Vec3& wo, Real) const {
    DeltaLobes all;
    all.add({reflected(wo, Vec3::UnitZ()), reflectance_, 1, 1, lobes()});
    return all;
}

}  // namespace caustic
