#pragma once

#include <cstdint>
#include <initializer_list>
#include <pcg_random.hpp>

#include "core/mixer.h"

namespace caustic {

/// Random numbers that belong to a work item, never to a thread.
///
/// A stream is named by a seed and any number of indices (figure, pixel, sample, dimension...). The same name gives the
/// same numbers whoever asks and in whatever order, so a result doesn't depend on how the work is spread over threads.
/// Generator: PCG64 (O'Neill 2014); names are mixed by SplitMix64's finaliser (Steele, Lea, Flood 2014, fig. 18).
class Random {
public:
    /// The stream of that name, at its start.
    Random(std::uint64_t seed, std::initializer_list<std::uint64_t> item) : engine_(mixed(seed, item)) {}

    /// Uniform in [0, 1), all 53 bits of the fraction random.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform among 0 ... n-1; n must be greater than 0.
    std::uint64_t below(std::uint64_t n) { return engine_(n); }

private:
    static std::uint64_t mixed(std::uint64_t seed, std::initializer_list<std::uint64_t> item) {
        std::uint64_t state = splitMix(seed + goldenStep);
        for (const std::uint64_t index : item) state = splitMix((state ^ index) + goldenStep);
        return state;
    }

    pcg64 engine_;
};

}  // namespace caustic
