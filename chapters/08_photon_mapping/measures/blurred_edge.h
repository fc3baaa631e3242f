#pragma once

#include <cstdint>

#include "math/real.h"

namespace caustic {

/// How wide a sharp border of light becomes when every place gets the mean of a disc: from where 10 % of the light is
/// seen to where 90 % is. The disc's share beyond a chord at the distance x r from its middle is 1/2 − (x √(1 − x²) +
/// asin x)/π.
/// @param radius  r, m
Real blurredEdgeWidth(Real radius);

/// The same, measured: photons lie at random on one side of a line.
/// @param photons  on a square metre
Real blurredEdgeWidth(Real radius, std::int64_t photons, std::uint64_t seed);

}  // namespace caustic
