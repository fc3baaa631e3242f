#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "math/real.h"

namespace caustic {

/// How often a method names the wrong nearest meeting, or one that isn't there, or none where there is one. Rays whose
/// first meeting is in the band of tangency are no trials.
struct NearestCount {
    std::string method;
    std::int64_t failures = 0;
    std::int64_t trials = 0;
};

/// What brute force finds out about the robust method and the report's starts on a set of rays.
struct RootExamination {
    std::int64_t rays = 0;
    std::int64_t meetings = 0;    ///< by brute force
    std::int64_t misses = 0;      ///< meetings outside the band that the robust method lost
    std::int64_t falseHits = 0;   ///< its roots outside the band where brute force has no meeting
    std::int64_t raysInBand = 0;  ///< rays with a meeting in the band
    Real worstDistance =
        0;  ///< largest |L(t) - B| of any of its roots, as a share of the size (with the origin's distance)
    std::vector<NearestCount> nearest;  ///< by method: the robust one, then the report's starts

    /// Adds another set's counts.
    RootExamination& operator+=(const RootExamination& other);
};

/// Names of the ray sets, random chords first.
std::vector<std::string> revolutionSetNames();
/// The same for patches.
std::vector<std::string> patchSetNames();

/// Examines surfaces of revolution (all of difficultProfiles in turn) with rays of one set. The same for any number of
/// threads.
RootExamination examineRevolution(std::size_t set, std::int64_t rays, std::uint64_t seed, int threads);

/// Examines patches (all of difficultPatches in turn) with rays of one set.
RootExamination examinePatches(std::size_t set, std::int64_t rays, std::uint64_t seed, int threads);

}  // namespace caustic
