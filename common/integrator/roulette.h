#pragma once

#include <optional>

#include "math/color.h"

namespace caustic {

/// Russian roulette: a path that carries little ends by chance, and one that survives counts for those that didn't, so
/// that the mean stays what it was. A path survives with the largest channel of `share` as its probability: always, and
/// unchanged, from 1 on; never at 0. Source: Arvo, Kirk 1990, Particle Transport and Image Synthesis.
/// @param share  of what it set out with the path still carries; at least 0
/// @param u      uniform in [0, 1)
/// @return what the survivor's throughput is multiplied by; nothing when the path ends
std::optional<Real> roulette(const Color& share, Real u);

}  // namespace caustic
