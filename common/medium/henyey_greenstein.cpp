#include "medium/henyey_greenstein.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/check.h"
#include "core/not_implemented.h"
#include "math/frame.h"

namespace caustic {

HenyeyGreenstein::HenyeyGreenstein(Real g) : g_(g) {
    checkArgument(g > -1 && g < 1, "mean cosine of a phase function", formatReal(g), "must be between -1 and 1");
}

Real HenyeyGreenstein::p(const Vec3& wo, const Vec3& wi) const {
    // 1 + g² − 2g cosθ = (1 − |g|)² + |g| · |wi ± wo|²: at the peak, where the first form loses all its digits, this
    // one doesn't.
    const Real away = (g_ >= 0 ? Vec3(wi + wo) : Vec3(wi - wo)).squaredNorm();
    const Real base = (1 - std::abs(g_)) * (1 - std::abs(g_)) + std::abs(g_) * away;
    // Henyey, Greenstein 1941, eq. 2.
    return std::numbers::inv_pi / 4 * (1 - g_) * (1 + g_) / (base * std::sqrt(base));
}

PhaseSample HenyeyGreenstein::sample(const Vec3& wo, const Vec2& u) const {
    //! [ex-11.5]
    // The distribution of cosθ inverted (PBR 11.3), as 1 − cosθ and 1 + cosθ: no difference of nearly equal numbers,
    // and nothing is divided by g.
    const Real d = 1 - g_ + 2 * g_ * u.x();
    const Real less = 2 * (1 - g_) * (1 - g_) * (1 - u.x()) * (1 + g_ * u.x()) / (d * d);
    const Real more = 2 * (1 + g_) * (1 + g_) * u.x() * (1 - g_ * (1 - u.x())) / (d * d);
    const Real cosine = (more - less) / 2;
    const Real sine = std::sqrt(less * more);
    const Real phi = 2 * std::numbers::pi * u.y();
    const Vec3 wi = Frame::around(-wo).toWorld({sine * std::cos(phi), sine * std::sin(phi), cosine}).normalized();
    const Real value = p(wo, wi);
    return {wi, value, value};
    //! [ex-11.5]
}

}  // namespace caustic
