#pragma once

#include "medium/phase_function.h"

namespace caustic {

/// Light goes on mostly forwards, or mostly backwards: p = (1 − g²) / (4π (1 + g² − 2g cosθ)^(3/2)), where θ is the
/// angle by which light is turned; so cosθ = −wo·wi. The mean of cosθ is g. Fog has about 0.8, air none, dust in the
/// way of the sun may have less than 0. Source: Henyey, Greenstein 1941, Diffuse Radiation in the Galaxy, Astrophysical
/// Journal 93, eq. 2.
class HenyeyGreenstein final : public PhaseFunction {
public:
    /// @param g  mean cosine, in (−1, 1); 0 for all directions alike
    /// @throws InputError for others
    explicit HenyeyGreenstein(Real g);

    Real p(const Vec3& wo, const Vec3& wi) const override;
    /// In proportion to p exactly: the density is p.
    PhaseSample sample(const Vec3& wo, const Vec2& u) const override;
    Real pdfW(const Vec3& wo, const Vec3& wi) const override { return p(wo, wi); }

private:
    Real g_;
};

}  // namespace caustic
