#pragma once

#include <memory>

#include "medium/medium.h"

namespace caustic {

/// A medium that is everywhere the same, and absorbs and scatters each channel as it likes: fog, smoke, milk. Of
/// density 0 it is empty space, bit for bit.
class HomogeneousMedium final : public Medium {
public:
    /// @param sigmaA  absorption coefficient of each channel, 1/m
    /// @param sigmaS  scattering coefficient of each channel, 1/m
    /// @param phase   into which directions it scatters; not null
    /// @throws InputError unless coefficients are finite and at least 0, and there is a phase function
    HomogeneousMedium(const Color& sigmaA, const Color& sigmaS, std::shared_ptr<const PhaseFunction> phase);

    Color transmittance(const Ray& ray, Real tEnd) const override;

    /// By the extinction of a channel that is picked at random, all three alike.
    DistanceSample sampleDistance(const Ray& ray, Real tEnd, Real uDistance, Real uChannel) const override;

    const PhaseFunction* phase() const override;
    Color sigmaS(const Vec3&) const override { return sigmaS_; }

private:
    Color passed(Real distance) const;

    Color sigmaS_;
    Color sigmaT_;
    std::shared_ptr<const PhaseFunction> phase_;
};

}  // namespace caustic
