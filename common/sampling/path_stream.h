#pragma once

#include <cstdint>

#include "core/mixer.h"
#include "sampling/sampler.h"

namespace caustic {

/// The uniform numbers of a path by dimension, or of a whole round of paths: a counter that starts at a hash of the
/// name, mixed. Names and dimensions are small numbers that differ by one, which is what the mixer is made for; and a
/// generator with a state of its own takes longer to start than to give the two numbers that are asked for.
/// Sources: Steele, Lea, Flood 2014, Fast Splittable Pseudorandom Number Generators, fig. 17 (the counter); Evensen
/// 2019, Better, Stronger Mixer and a Test Procedure ("moremur", the mixer).
class PathStream {
public:
    /// @param round  the path's index, or what several paths share
    PathStream(std::uint64_t seed, const PathName& path, std::int64_t round) {
        const auto column = static_cast<std::uint32_t>(path.pixel.x);
        const auto row = static_cast<std::uint32_t>(path.pixel.y);
        start_ = mixed(seed + goldenStep);
        start_ = mixed((start_ ^ path.stream) + goldenStep);
        start_ = mixed((start_ ^ (std::uint64_t{column} << 32 | row)) + goldenStep);
        start_ = mixed((start_ ^ static_cast<std::uint64_t>(round)) + goldenStep);
    }

    /// 64 random bits.
    std::uint64_t bits(Dimension dimension) const {
        return mixed(start_ + static_cast<std::uint64_t>(dimension.index + 1) * goldenStep);
    }

    /// Uniform in [0, 1), all 53 bits of the fraction random.
    Real number(Dimension dimension) const { return static_cast<Real>(bits(dimension) >> 11) * 0x1p-53; }

    /// Uniform in [0, 1)², from this dimension and the next one.
    Vec2 pair(Dimension dimension) const { return {number(dimension), number({dimension.index + 1})}; }

private:
    static constexpr std::uint64_t mixed(std::uint64_t x) {
        x = (x ^ (x >> 27)) * 0x3c79ac492ba7b653ULL;
        x = (x ^ (x >> 33)) * 0x1c69b3f74ac4ae35ULL;
        return x ^ (x >> 27);
    }

    std::uint64_t start_;
};

}  // namespace caustic
