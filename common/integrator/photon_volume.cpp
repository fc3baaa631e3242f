#include "integrator/photon_volume.h"

#include <numbers>

#include "core/not_implemented.h"

namespace caustic {

Real beamKernel(Real squaredDistance, Real radius) {
    const Real squared = radius * radius;
    const Real inside = 1 - squaredDistance / squared;
    // Silverman 1986, eq. 4.5, scaled to the radius.
    return 3 * inside * inside / (std::numbers::pi * squared);
}

PhotonVolume::PhotonVolume(std::span<const Photon> photons) : tree_(pointsOf(photons)) {
    photons_.reserve(photons.size());
    for (const std::uint32_t i : tree_.order()) photons_.push_back(photons[i]);
}

Color PhotonVolume::radiance(const MediumSpan& span, const BeamSettings& settings) const {
    //! [ex-11.7]
    Color sum = Color::Zero();
    const Vec3 wo = -span.ray.direction;
    const Beam beam = {{span.ray.origin, span.ray.direction, 0, span.tEnd}, settings.radius};
    tree_.along(beam, [&](const BeamPoint& near) {
        const Photon& photon = photons_[near.place];
        if (photon.length + settings.eyeSegments > settings.mostSegments) return;
        if (photon.way == PhotonWay::Direct && !settings.direct) return;
        // Lesson, eq. (11.10): the power holds σ_s already.
        sum += photon.power * span.medium->transmittance(span.ray, near.t) *
               (span.medium->phase()->p(wo, photon.wi) * beamKernel(near.squaredDistance, settings.radius));
    });
    return sum;
    //! [ex-11.7]
}

}  // namespace caustic
