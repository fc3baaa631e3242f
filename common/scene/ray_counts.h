#pragma once

#include <cstdint>

namespace caustic {

/// How much work was done in a scene, to see that nothing is done that it doesn't need. It is handed from function to
/// function rather than kept by the scene, which all threads share: so the sums are the same for any number of threads,
/// and they need no lock.
struct RayCounts {
    std::int64_t rays = 0;             ///< searches for the nearest hit
    std::int64_t shadowRays = 0;       ///< tests whether anything is in the way
    std::int64_t crossings = 0;        ///< boundaries of objects with an interior
    std::int64_t transmittances = 0;   ///< evaluations of how much a medium lets pass
    std::int64_t distanceSamples = 0;  ///< distances sampled in media that scatter
    std::int64_t lensSamples = 0;      ///< points of a lens
    std::int64_t textureLookups = 0;   ///< BSDFs made from colours that vary

    /// Both together.
    RayCounts& operator+=(const RayCounts& other) {
        rays += other.rays;
        shadowRays += other.shadowRays;
        crossings += other.crossings;
        transmittances += other.transmittances;
        distanceSamples += other.distanceSamples;
        lensSamples += other.lensSamples;
        textureLookups += other.textureLookups;
        return *this;
    }
};

}  // namespace caustic
