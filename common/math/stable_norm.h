#pragma once

#include <cmath>

#include "math/vector.h"

namespace caustic {

/// Length of a vector whose squares may overflow or underflow, scaled by a power of two so that only the sum rounds.
/// Not Eigen's stableNorm(): that groups its sum by where the vector lies in memory, so that the last bit of the same
/// vector differs from one run to the next.
/// @return the length; infinite if the vector isn't finite
template <typename Vector>
Real stableNorm(const Vector& v) {
    const Real largest = v.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !std::isfinite(largest)) return v.cwiseAbs().sum();
    const int exponent = std::ilogb(largest);
    Real sum = 0;
    for (Eigen::Index i = 0; i < v.size(); ++i) {
        const Real scaled = std::scalbn(v[i], -exponent);
        sum += scaled * scaled;
    }
    return std::scalbn(std::sqrt(sum), exponent);
}

}  // namespace caustic
