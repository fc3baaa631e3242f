#pragma once

#include <optional>

#include "math/color.h"
#include "math/ray.h"

namespace caustic {

class PhaseFunction;

/// Result of Medium::sampleDistance: where light is scattered.
struct DistanceSample {
    Real t = 0;                    ///< in lengths of the ray's direction
    Color weight = Color::Ones();  ///< scattering coefficient σ_s times transmittance, over the density of t
};

/// What fills the space between surfaces. Coefficients are per metre: absorption sigmaA, scattering sigmaS, extinction
/// sigmaT = sigmaA + sigmaS. Never changes once it is made.
class Medium {
public:
    virtual ~Medium() = default;

    /// The share of light that passes the ray from its origin to t = tEnd, each channel in [0, 1].
    /// @param tEnd  at least 0, in lengths of the ray's direction; may be infinite
    virtual Color transmittance(const Ray& ray, Real tEnd) const = 0;

    /// Picks where along the ray, before t = tEnd, light is scattered next; nothing when it gets that far without, and
    /// nothing ever in a medium that doesn't scatter.
    /// The last argument is a uniform number in [0, 1).
    virtual std::optional<DistanceSample> sampleDistance(const Ray&, Real /*tEnd*/, Real /*u*/) const {
        return std::nullopt;
    }

    /// How it scatters; null when it doesn't.
    virtual const PhaseFunction* phase() const { return nullptr; }
};

}  // namespace caustic
