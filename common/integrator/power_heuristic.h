#pragma once

#include "math/real.h"

namespace caustic {

/// The weight of a sample that one of two methods took which could both have taken it: its density squared over the sum
/// of both squares. Source: Veach 9.2.4, eq. 9.13, β = 2.
/// @param own    density of the method that took it, greater than 0; in the same measure as `other`
/// @param other  density of the method that did not, at least 0
inline Real powerHeuristic(Real own, Real other) {
    const Real ratio = other / own;
    return 1 / (1 + ratio * ratio);
}

}  // namespace caustic
