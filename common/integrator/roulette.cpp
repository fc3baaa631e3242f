#include "integrator/roulette.h"

#include <algorithm>

namespace caustic {

std::optional<Real> roulette(const Color& share, Real u) {
    //! [roulette]
    const Real survival = share.maxCoeff();
    if (survival >= 1) return 1;
    if (u >= survival) return std::nullopt;
    // Arvo, Kirk 1990.
    return 1 / survival;
    //! [roulette]
}

}  // namespace caustic
