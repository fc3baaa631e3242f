#include "integrator/radius_rule.h"

#include <cmath>

#include "core/not_implemented.h"
#include "math/log_gamma.h"

namespace caustic {

Real radiusOfPass(Real first, Real alpha, std::int64_t pass) {
    //! [ex-09.3]
    // The product in closed form: Γ(i + 1 + α) / (Γ(1 + α) Γ(i + 2)).
    const auto i = static_cast<Real>(pass);
    return first * std::exp(0.5 * (logGamma(i + 1 + alpha) - logGamma(1 + alpha) - logGamma(i + 2)));
    //! [ex-09.3]
}

void update(PointStatistics& pixel, const Gathered& found, Real alpha) {
    //! [ex-09.4]
    if (found.photons == 0) return;
    const auto m = static_cast<Real>(found.photons);
    const Real share = (pixel.photons + alpha * m) / (pixel.photons + m);
    pixel.photons += alpha * m;
    pixel.radius *= std::sqrt(share);
    pixel.flux = (pixel.flux + found.flux) * share;
    //! [ex-09.4]
}

}  // namespace caustic
