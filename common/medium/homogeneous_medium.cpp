#include "medium/homogeneous_medium.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"

namespace caustic {

HomogeneousMedium::HomogeneousMedium(const Color& sigmaA, const Color& sigmaS,
                                     std::shared_ptr<const PhaseFunction> phase)
    : sigmaS_(sigmaS), sigmaT_(sigmaA + sigmaS), phase_(std::move(phase)) {
    for (int channel = 0; channel < 3; ++channel) {
        for (const Real sigma : {sigmaA[channel], sigmaS[channel]}) {
            checkFinite(sigma, "coefficient of a medium");
            checkArgument(sigma >= 0, "coefficient of a medium", formatReal(sigma), "must be at least 0");
        }
    }
    checkArgument(phase_ != nullptr, "medium", "", "needs a phase function");
}

Color HomogeneousMedium::transmittance(const Ray& ray, Real tEnd) const { return passed(tEnd * ray.direction.norm()); }

DistanceSample HomogeneousMedium::sampleDistance(const Ray& ray, Real tEnd, Real uDistance, Real uChannel) const {
    //! [coloured-distance]
    const Real length = ray.direction.norm();
    const Real end = tEnd * length;
    const Real sigma = sigmaT_[std::min(2, static_cast<int>(3 * uChannel))];
    // The distribution 1 − e^(−σ d) inverted.
    const Real distance = sigma > 0 ? -std::log1p(-uDistance) / sigma : end;
    if (distance >= end) {
        const Color T = passed(end);
        // PBR, 3rd ed., 15.2: probability of passing, mean over the channels that might have been picked.
        return {false, tEnd, T / T.mean(), T.mean()};
    }
    const Color T = passed(distance);
    // PBR, 3rd ed., 15.2: density of the distance, mean over the channels.
    const Real pdf = (sigmaT_ * T).mean();
    return {true, distance / length, sigmaS_ * T / pdf, pdf};
    //! [coloured-distance]
}

const PhaseFunction* HomogeneousMedium::phase() const { return (sigmaS_ > 0).any() ? phase_.get() : nullptr; }

// A channel that nothing stops passes however far it goes: no 0 · ∞.
Color HomogeneousMedium::passed(Real distance) const {
    Color T;
    for (int channel = 0; channel < 3; ++channel)
        T[channel] = sigmaT_[channel] == 0 ? 1 : std::exp(-sigmaT_[channel] * distance);
    return T;
}

}  // namespace caustic
