#include "reference.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace caustic {

Polarised referenceDielectric(Real cosO, Real eta) {
    const long double o = std::acos(static_cast<long double>(cosO));
    const long double sine = std::sin(o) / static_cast<long double>(eta);
    if (sine >= 1) return {1, 1};
    const long double i = std::asin(sine);
    // At normal incidence both are 0/0; a little aside, the difference is of the order of its square.
    if (o < 1e-9L) {
        const Real r = (eta - 1) / (eta + 1);
        return {r * r, r * r};
    }
    const long double across = std::sin(o - i) / std::sin(o + i);
    const long double within = std::tan(o - i) / std::tan(o + i);
    return {static_cast<Real>(across * across), static_cast<Real>(within * within)};
}

Real referenceConductor(Real cosO, Real eta, Real k) {
    const std::complex<Real> index(eta, k);
    const std::complex<Real> cosI = std::sqrt(Real(1) - (1 - cosO * cosO) / (index * index));
    const Real across = std::norm((cosO - index * cosI) / (cosO + index * cosI));
    const Real within = std::norm((index * cosO - cosI) / (index * cosO + cosI));
    return (across + within) / 2;
}

Real referenceAlbedo(Real cosO, Real eta, Real k, Real alpha) {
    constexpr int rings = 1500;
    constexpr int spokes = 360;
    const Real sinO = std::sqrt(1 - cosO * cosO);
    const auto hidden = [&](Real cosine) {
        return (std::hypot(1, alpha * std::sqrt(1 - cosine * cosine) / cosine) - 1) / 2;
    };
    Real sum = 0;
    for (int ring = 0; ring < rings; ++ring) {
        // Facets less steep than the tangent t are the share t²/(α² + t²): rings of equal share.
        const Real share = (ring + 0.5) / rings;
        const Real tangent = alpha * std::sqrt(share / (1 - share));
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const Real angle = 2 * std::numbers::pi * (spoke + 0.5) / spokes;
            // wo and wi seen from a facet of slope (p, q); its normal is (−p, −q, 1) / √(1 + t²).
            const Real facing = (cosO - tangent * std::cos(angle) * sinO) / std::hypot(1, tangent);
            if (facing <= 0) continue;
            const Real cosI = 2 * facing / std::hypot(1, tangent) - cosO;
            if (cosI <= 0) continue;
            // D cosM dwm = share of the facets; f cosI dwi = F D G/(4 cosO) · 4 (wo · wm) dwm.
            const Real seen = 1 / (1 + hidden(cosO) + hidden(cosI));
            sum +=
                referenceConductor(std::min(facing, Real(1)), eta, k) * seen * facing * std::hypot(1, tangent) / cosO;
        }
    }
    return sum / (rings * spokes);
}

}  // namespace caustic
