#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// The direction with this z, `turn` turns around the axis.
Vec3 aroundAxis(Real z, Real turn) {
    const Real r = std::sqrt(std::max(Real(0), 1 - z * z));
    return {r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z};
}

}  // namespace

// PBR, 4th ed., A.5.1: Shirley and Chiu's map.
Vec2 concentricDisc(const Vec2& u) {
    const Vec2 offset = 2 * u - Vec2::Ones();
    if (offset.isZero(0)) return Vec2::Zero();
    const bool wide = std::abs(offset.x()) > std::abs(offset.y());
    const Real r = wide ? offset.x() : offset.y();
    const Real angle = wide ? pi / 4 * (offset.y() / offset.x()) : pi / 2 - pi / 4 * (offset.x() / offset.y());
    return r * Vec2(std::cos(angle), std::sin(angle));
}

// PBR, 4th ed., A.5.3: Malley's method.
Vec3 cosineHemisphere(const Vec2& u) {
    const Vec2 disc = concentricDisc(u);
    return {disc.x(), disc.y(), std::sqrt(std::max(Real(0), 1 - disc.squaredNorm()))};
}

// PBR, 4th ed., A.5.2: z is uniform.
Vec3 uniformSphere(const Vec2& u) { return aroundAxis(1 - 2 * u.x(), u.y()); }

// PBR, 4th ed., A.5.4: z is uniform, from cosLimit on.
Vec3 uniformCone(const Vec2& u, Real cosLimit) { return aroundAxis(1 - u.x() * (1 - cosLimit), u.y()); }

// Lafortune, Willems 1994: the share zⁿ⁺¹ of all directions is further from the axis, inverted.
Vec3 powerHemisphere(const Vec2& u, Real exponent) {
    return aroundAxis(std::pow(1 - u.x(), 1 / (exponent + 1)), u.y());
}

}  // namespace caustic
