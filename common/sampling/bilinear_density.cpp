#include "sampling/bilinear_density.h"

#include <algorithm>
#include <cmath>

namespace caustic {

namespace {

// A number in [0, 1) whose density goes linearly from a to b: solves (a x + (b − a) x²/2) / ((a + b)/2) = u. PBR, 4th
// ed., eq. 2.23, in the form that loses no digits where a and b are alike.
Real sampleLinear(Real u, Real a, Real b) {
    if (a == b) return u;
    const Real x = u * (a + b) / (a + std::sqrt(std::lerp(a * a, b * b, u)));
    // Neither end: there the density may be 0, and 1 is outside.
    return std::clamp(x, Real(0x1p-60), std::nextafter(Real(1), Real(0)));
}

}  // namespace

Real BilinearDensity::value(const Vec2& at) const {
    return std::lerp(std::lerp(at00, at10, at.x()), std::lerp(at01, at11, at.x()), at.y());
}

Vec2 BilinearDensity::sample(const Vec2& u) const {
    const Real y = sampleLinear(u.y(), at00 + at10, at01 + at11);
    return {sampleLinear(u.x(), std::lerp(at00, at01, y), std::lerp(at10, at11, y)), y};
}

}  // namespace caustic
