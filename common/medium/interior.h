#pragma once

#include <memory>

#include "medium/medium.h"

namespace caustic {

/// What fills a closed object.
struct Interior {
    Real ior = 1;                          ///< index of refraction, greater than 0
    std::shared_ptr<const Medium> medium;  ///< what absorbs or scatters in it; null for neither

    /// Where objects overlap, the one with the highest priority is there and the others aren't. So a drink may reach
    /// into its glass by a little, and no gap of air comes between them. Objects that touch should overlap so: of two
    /// faces at the very same place a ray crosses one only.
    int priority = 0;
};

}  // namespace caustic
