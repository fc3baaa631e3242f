#pragma once

#include "medium/medium.h"

namespace caustic {

/// A homogeneous medium that absorbs and doesn't scatter: coloured glass.
class AbsorbingMedium final : public Medium {
public:
    /// @param sigmaA  absorption coefficient of each channel, 1/m
    /// @throws InputError unless finite and at least 0
    explicit AbsorbingMedium(const Color& sigmaA);

    /// The medium that lets this share of light pass one metre: the report's I, which is e^(−sigmaA).
    /// @throws InputError unless each channel is in (0, 1]
    static AbsorbingMedium ofTransmittance(const Color& perMetre);

    /// Absorption coefficient, 1/m.
    const Color& sigmaA() const { return sigmaA_; }

    /// e^(−sigmaA · d) for a distance d in metres; tEnd counts in lengths of the direction. A channel with sigmaA 0
    /// passes any distance, an infinite one too. Source: Beer 1852; Lambert 1760.
    Color transmittance(const Ray& ray, Real tEnd) const override;

private:
    Color sigmaA_;
};

}  // namespace caustic
