#pragma once

#include "integrator/sppm.h"
#include "scene/scene.h"

namespace caustic {

/// One pixel whose answer is known: a floor, y = 0, that a spotlight lights over a horizontal mirror above it. The
/// mirror shows the lamp straight above the pixel's place at the height h; so at the distance r from there the
/// irradiance is I h/(h² + r²)^(3/2), and its mean over a disc is known as well.
struct SpotUnderMirror {
    Real mirrorHeight = 0.25;  ///< m
    Real lampHeight = 0.2;     ///< m, below the mirror
    Real halfAngle = 0.7;      ///< of the spotlight's cone
    Real floorReflectance = 0.6;
    Real intensity = 1;  ///< W/sr

    /// Height of the lamp's image, m.
    Real apparent() const { return 2 * mirrorHeight - lampHeight; }

    /// With a camera of one pixel.
    Scene scene() const;

    /// Radiance of the pixel.
    Real truth() const;

    /// How much darker the mean over a disc is than its middle, as a share of it; while the cone reaches so far.
    Real biasWithin(Real radius) const;

    /// The radiance that SPPM finds, passes looked at by `look` when there is one.
    Real found(const SppmSettings& settings, std::int64_t passes, std::uint64_t seed,
               const std::function<void(std::int64_t passes, Real radiance)>& look = {}) const;
};

}  // namespace caustic
