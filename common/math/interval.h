#pragma once

#include "math/real.h"

namespace caustic {

/// All numbers from `lower` to `upper`, both included; empty when they stand the wrong way round, or when one is NaN.
template <typename Scalar>
struct BasicInterval {
    Scalar lower;
    Scalar upper;

    /// Whether no number is in it.
    bool empty() const { return !(lower <= upper); }
};

/// An interval of `Real`: of a ray's t, mostly.
using Interval = BasicInterval<Real>;

}  // namespace caustic
