#include "material/dielectric_bsdf.h"

#include "core/not_implemented.h"
#include "material/directions.h"
#include "material/fresnel.h"

namespace caustic {

DeltaLobes DielectricBsdf::localDeltaLobes(const Vec3& wo, Real eta) const {
    //! [ex-06.3]
    DeltaLobes all;
    // Seen from behind ns, where only ng says that this is the front: no direction there is right.
    if (wo.z() < 0) return all;
    const auto through = refracted(wo, Vec3::UnitZ(), eta);
    const Real reflects = through ? fresnelDielectric(wo.z(), eta) : 1;
    const Real transmits = 1 - reflects;
    // PBR, 4th ed., 9.5: a share for each in energy, which is also how often it is chosen.
    if (reflects > 0)
        all.add({reflected(wo, Vec3::UnitZ()), Color::Constant(reflects), reflects, 1,
                 LobeFlags::Delta | LobeFlags::Reflection});
    if (transmits > 0)
        all.add({*through, Color::Constant(transmits), transmits, eta, LobeFlags::Delta | LobeFlags::Transmission});
    return all;
    //! [ex-06.3]
}

}  // namespace caustic
