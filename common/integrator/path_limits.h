#pragma once

namespace caustic {

/// How long paths get.
struct PathLimits {
    /// Segments between eye and light, at most; at least 1. Light that takes more is lost.
    int maxLength = 10;

    /// The first vertex of a walk, counted from 0, at which roulette is played; at least 0.
    int rouletteStart = 1;
};

/// Passes the limits on.
/// @throws InputError when one is out of its range
const PathLimits& checkLimits(const PathLimits& limits);

}  // namespace caustic
