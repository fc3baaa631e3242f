#include "material/conductor_bsdf.h"

#include "material/directions.h"
#include "material/fresnel.h"

namespace caustic {

DeltaLobes ConductorBsdf::localDeltaLobes(const Vec3& wo, Real) const {
    DeltaLobes all;
    // Seen from behind ns, where only ng says that this is the front: no direction there is right.
    if (wo.z() < 0) return all;
    // PBR, 4th ed., 9.4: one direction, with what Fresnel's equations reflect.
    all.add({reflected(wo, Vec3::UnitZ()), fresnelConductor(wo.z(), metal_.eta, metal_.k), 1, 1, lobes()});
    return all;
}

}  // namespace caustic
