#include "material/fresnel.h"

#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

namespace {

// (1 − x)⁵
Real fifthPower(Real x) {
    const Real rest = 1 - x;
    const Real squared = rest * rest;
    return squared * squared * rest;
}

}  // namespace

Real fresnelDielectric(Real cosO, Real eta) {
    //! [ex-06.1]
    // (eta · cosI)² by Snell's law. Written so, it loses no digits where eta is close to 1 or wo along the surface.
    const Real squared = (eta - 1) * (eta + 1) + cosO * cosO;
    if (squared <= 0) return 1;
    const Real etaCosI = std::sqrt(squared);
    // PBR, 4th ed., 9.3.5: Fresnel's amplitudes of both polarisations; energies are their squares.
    const Real perpendicular = (cosO - etaCosI) / (cosO + etaCosI);
    const Real parallel = (eta * eta * cosO - etaCosI) / (eta * eta * cosO + etaCosI);
    return (perpendicular * perpendicular + parallel * parallel) / 2;
    //! [ex-06.1]
}

Real schlick(Real cosO, Real eta) {
    //! [ex-06.2]
    // Fresnel at normal incidence, then Schlick 1994.
    const Real atNormal = (1 - eta) / (1 + eta);
    const Real r0 = atNormal * atNormal;
    if (eta >= 1) return r0 + (1 - r0) * fifthPower(cosO);
    const Real cosSquaredI = 1 - (1 - cosO * cosO) / (eta * eta);
    if (cosSquaredI <= 0) return 1;
    return r0 + (1 - r0) * fifthPower(std::sqrt(cosSquaredI));
    //! [ex-06.2]
}

// Schlick 1994.
Color schlick(Real cosO, const Color& r0) { return r0 + (1 - r0) * fifthPower(cosO); }

Color fresnelConductor(Real cosO, const Color& eta, const Color& k) {
    const Real cosSquared = cosO * cosO;
    if (cosSquared == 0) return Color::Ones();  // along the surface; 0/0 for an index of 1
    const Real sinSquared = 1 - cosSquared;
    // PBR, 4th ed., 9.3.6, without complex numbers: a + ib is the complex index times the complex cosine inside.
    const Color difference = eta.square() - k.square() - sinSquared;
    const Color squares = (difference.square() + 4 * eta.square() * k.square()).sqrt();  // a² + b²
    const Color a = ((squares + difference) / 2).max(0).sqrt();
    const Color perpendicular = (squares + cosSquared - 2 * cosO * a) / (squares + cosSquared + 2 * cosO * a);
    const Color even = cosSquared * squares + sinSquared * sinSquared;
    const Color odd = 2 * cosO * sinSquared * a;
    return perpendicular * (1 + (even - odd) / (even + odd)) / 2;
}

}  // namespace caustic
