#pragma once

#include "math/color.h"
#include "math/ray.h"
#include "medium/phase_function.h"

namespace caustic {

/// Result of Medium::sampleDistance: either light is scattered at a point of the ray, or it passes to the end. Both
/// come with the weight that a path's throughput is multiplied by, and with the density that the weight is divided by
/// already. T is the transmittance up to t.
struct DistanceSample {
    bool scattered = false;  ///< whether light is scattered at t, before the end
    Real t = 0;              ///< where, in lengths of the ray's direction; the end when it passes

    /// Scattered: σ_s T over the density of t. Passed: T over the probability of passing.
    Color weight = Color::Ones();

    /// Scattered: density of the distance, 1/m. Passed: probability of passing, in (0, 1]. Both are those of all the
    /// ways in which the medium could have picked it: the mean over the channels where it picks a channel at random.
    Real pdf = 1;
};

/// What fills the space between surfaces. Coefficients are per metre: absorption sigmaA, scattering sigmaS, extinction
/// sigmaT = sigmaA + sigmaS, one of each for each channel. Never changes once it is made.
class Medium {
public:
    virtual ~Medium() = default;

    /// The share of light that passes the ray from its origin to t = tEnd, neither absorbed nor scattered: each channel
    /// in [0, 1].
    /// @param tEnd  at least 0, in lengths of the ray's direction; may be infinite
    virtual Color transmittance(const Ray& ray, Real tEnd) const = 0;

    /// Picks where along the ray, before t = tEnd, light is scattered next, or that it gets to the end without.
    ///
    /// Unbiased in each channel, whatever colour the coefficients have: the mean of scattered samples' weights is
    /// ∫ σ_s T dt over the way (in metres), and that of passing ones T at the end. A medium that doesn't scatter passes
    /// always, with its transmittance as weight. Source: Pharr, Jakob,
    /// Humphreys 2016, Physically Based Rendering, 3rd edition, 15.2.
    /// @param tEnd       greater than 0, in lengths of the ray's direction; may be infinite
    /// @param uDistance  uniform in [0, 1)
    /// @param uChannel   another one: which channel's extinction the distance is picked by
    virtual DistanceSample sampleDistance(const Ray& ray, Real tEnd, [[maybe_unused]] Real uDistance,
                                          [[maybe_unused]] Real uChannel) const {
        return {false, tEnd, transmittance(ray, tEnd), 1};
    }

    /// Into which directions it scatters; null when it doesn't scatter. The medium keeps it alive.
    virtual const PhaseFunction* phase() const { return nullptr; }

    /// Scattering coefficient of each channel at a point, 1/m: for whoever looks along a ray at places of its own
    /// choice and not at those that sampleDistance picks. 0 everywhere in a medium that doesn't scatter.
    virtual Color sigmaS(const Vec3&) const { return Color::Zero(); }
};

}  // namespace caustic
