#pragma once

#include "core/random.h"
#include "sampling/sampler.h"

namespace caustic {

/// The random stream of one dimension of a path, or of a whole round of paths.
/// @param round  the path's index, or what several paths share
inline Random pathStream(std::uint64_t seed, const PathName& path, Dimension dimension, std::int64_t round) {
    return {seed,
            {path.stream, static_cast<std::uint64_t>(path.pixel.x), static_cast<std::uint64_t>(path.pixel.y),
             static_cast<std::uint64_t>(dimension.index), static_cast<std::uint64_t>(round)}};
}

}  // namespace caustic
