#pragma once

#include "math/vector.h"

namespace caustic {

/// Result of PhaseFunction::sample.
struct PhaseSample {
    Vec3 wi = Vec3::UnitZ();  ///< unit direction that light comes from, away from the point
    Real p = 0;               ///< value of the phase function, 1/sr
    Real pdfW = 0;            ///< density of wi over solid angle, 1/sr; never 0
};

/// Into which directions a medium scatters light. Both directions are unit length and point away from the place, as
/// those of a BSDF do: light that goes straight on has wi = −wo.
///
/// Normalised, ∫ p dω = 1 for every wo: what is absorbed is the medium's coefficients' affair, not the phase
/// function's. Symmetric, p(wo, wi) = p(wi, wo), so it is the same for both transport modes. Source: PBR 11.3.
class PhaseFunction {
public:
    virtual ~PhaseFunction() = default;

    /// Its value, 1/sr.
    virtual Real p(const Vec3& wo, const Vec3& wi) const = 0;

    /// Samples wi about in proportion to p.
    /// @param wo  unit direction to where the path came from
    /// @param u   two uniform numbers in [0, 1)
    virtual PhaseSample sample(const Vec3& wo, const Vec2& u) const = 0;

    /// Density over solid angle with which sample picks wi, 1/sr. Swap the two for the reverse.
    virtual Real pdfW(const Vec3& wo, const Vec3& wi) const = 0;
};

}  // namespace caustic
