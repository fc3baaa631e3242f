#pragma once

#include <math.h>  // lgamma_r, which <cmath> doesn't have

#include "math/real.h"

namespace caustic {

/// log Γ(x) for x > 0. std::lgamma writes the sign to a global variable, from all threads at once.
inline Real logGamma(Real x) {
    int sign = 0;
    return ::lgamma_r(x, &sign);
}

}  // namespace caustic
