#include "medium/absorbing_medium.h"

#include <cmath>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

AbsorbingMedium::AbsorbingMedium(const Color& sigmaA) : sigmaA_(sigmaA) {
    for (const Real channel : sigmaA) {
        checkFinite(channel, "absorption coefficient");
        checkArgument(channel >= 0, "absorption coefficient", formatReal(channel), "must be at least 0");
    }
}

AbsorbingMedium AbsorbingMedium::ofTransmittance(const Color& perMetre) {
    for (const Real channel : perMetre)
        checkArgument(channel > 0 && channel <= 1, "transmittance of one metre", formatReal(channel),
                      "must be greater than 0 and at most 1");
    return AbsorbingMedium(-perMetre.log() + Real(0));
}

Color AbsorbingMedium::transmittance(const Ray& ray, Real tEnd) const {
    //! [ex-05.3]
    const Real distance = tEnd * ray.direction.norm();
    Color passed;
    // PBR, 4th ed., 11.2: Beer's law. A channel that isn't absorbed passes however far it goes: 0 · ∞ must not come
    // into it.
    for (int channel = 0; channel < 3; ++channel)
        passed[channel] = sigmaA_[channel] == 0 ? 1 : std::exp(-sigmaA_[channel] * distance);
    return passed;
    //! [ex-05.3]
}

}  // namespace caustic
