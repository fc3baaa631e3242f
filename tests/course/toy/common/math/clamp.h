#pragma once

#include "core/not_implemented.h"

namespace caustic {

/// The value of [low, high] that is nearest to `value`.
template <typename Number>
Number clampTo(Number value, Number low, Number high) {
    //! [ex-01.4]
    if (value < low) return low;
    return value > high ? high : value;
    //! [ex-01.4]
}

}  // namespace caustic
