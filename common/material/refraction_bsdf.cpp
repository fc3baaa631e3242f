#include "material/refraction_bsdf.h"

#include "material/directions.h"

namespace caustic {

DeltaLobes RefractionBsdf::localDeltaLobes(const Vec3& wo, Real eta) const {
    constexpr LobeFlags reflection = LobeFlags::Delta | LobeFlags::Reflection;
    constexpr LobeFlags transmission = LobeFlags::Delta | LobeFlags::Transmission;
    const Vec3 mirrored = reflected(wo, Vec3::UnitZ());
    DeltaLobes all;
    // Seen from behind ns, where only ng says that this is the front: no direction there is right.
    if (wo.z() < 0) return all;
    const auto through = refracted(wo, Vec3::UnitZ(), eta);
    if (!through) {
        all.add({mirrored, reflectance_ + transmittance_, 1, 1, reflection});
        return all;
    }
    const Real reflects = reflectance_.maxCoeff();
    const Real transmits = transmittance_.maxCoeff();
    if (reflects > 0) all.add({mirrored, reflectance_, reflects / (reflects + transmits), 1, reflection});
    if (transmits > 0) all.add({*through, transmittance_, transmits / (reflects + transmits), eta, transmission});
    return all;
}

}  // namespace caustic
