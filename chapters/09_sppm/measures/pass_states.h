#pragma once

#include <array>
#include <vector>

#include "figure/figure.h"
#include "measures/methods.h"

namespace caustic {

/// What SPPM is at after so many passes.
struct PassState {
    Method method;
    std::int64_t passes = 0;
    std::array<Real, 5> radii{};  ///< smallest, lower quartile, median, upper quartile, largest of the pixels', m
    Real memory = 0;              ///< that the process keeps, MiB
};

/// The caustic in the mirror by both rules, looked at after 1, 2, 4 … passes.
std::vector<PassState> passStates(FigureContext& context);

}  // namespace caustic
