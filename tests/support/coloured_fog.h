#pragma once

#include "medium/medium.h"
#include "support/isotropic_phase.h"

namespace caustic::test {

/// A homogeneous medium that absorbs and scatters, each channel as it likes: the plainest one that a scene can be
/// filled with, to see whether everything else treats scattering rightly.
class ColouredFog final : public Medium {
public:
    /// @param sigmaA  absorption coefficient of each channel, 1/m, at least 0
    /// @param sigmaS  scattering coefficient of each channel, 1/m, at least 0
    ColouredFog(const Color& sigmaA, const Color& sigmaS) : sigmaS_(sigmaS), sigmaT_(sigmaA + sigmaS) {}

    Color transmittance(const Ray& ray, Real tEnd) const override;

    /// By the extinction of a channel that is picked at random, all three alike.
    DistanceSample sampleDistance(const Ray& ray, Real tEnd, Real uDistance, Real uChannel) const override;

    const PhaseFunction* phase() const override { return &phase_; }

private:
    Color passed(Real distance) const;

    Color sigmaS_;
    Color sigmaT_;
    IsotropicPhase phase_;
};

}  // namespace caustic::test
