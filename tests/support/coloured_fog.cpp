#include "support/coloured_fog.h"

#include <algorithm>
#include <cmath>

namespace caustic::test {

Color ColouredFog::transmittance(const Ray& ray, Real tEnd) const { return passed(tEnd * ray.direction.norm()); }

DistanceSample ColouredFog::sampleDistance(const Ray& ray, Real tEnd, Real uDistance, Real uChannel) const {
    const Real length = ray.direction.norm();
    const Real end = tEnd * length;
    const Real sigma = sigmaT_[std::min(2, static_cast<int>(3 * uChannel))];
    const Real distance = sigma > 0 ? -std::log1p(-uDistance) / sigma : end;
    if (distance >= end) {
        const Color T = passed(end);
        return {false, tEnd, T / T.mean(), T.mean()};
    }
    const Color T = passed(distance);
    const Real pdf = (sigmaT_ * T).mean();
    return {true, distance / length, sigmaS_ * T / pdf, pdf};
}

// Whatever passes a clear channel passes to infinity: no 0 · ∞.
Color ColouredFog::passed(Real distance) const {
    Color T;
    for (int channel = 0; channel < 3; ++channel)
        T[channel] = sigmaT_[channel] == 0 ? 1 : std::exp(-sigmaT_[channel] * distance);
    return T;
}

}  // namespace caustic::test
