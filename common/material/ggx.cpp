#include "material/ggx.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/not_implemented.h"
#include "math/log_gamma.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

}  // namespace

Ggx::Ggx(Real alphaX, Real alphaY) : alphaX_(std::max(alphaX, smoothBelow)), alphaY_(std::max(alphaY, smoothBelow)) {}

Real Ggx::D(const Vec3& wm) const {
    //! [ex-06.4]
    if (wm.z() <= 0) return 0;
    const Real x = wm.x() / alphaX_;
    const Real y = wm.y() / alphaY_;
    const Real squared = x * x + y * y + wm.z() * wm.z();
    // PBR, 4th ed., eq. 9.16, in coordinates; Walter 2007, eq. 33 for one roughness.
    return 1 / (pi * alphaX_ * alphaY_ * squared * squared);
    //! [ex-06.4]
}

Real Ggx::lambda(const Vec3& w) const {
    //! [ex-06.5]
    const Real x = alphaX_ * w.x();
    const Real y = alphaY_ * w.y();
    // PBR, 4th ed., eq. 9.20; Heitz 2014, eq. 72 for one roughness.
    return (std::sqrt(1 + (x * x + y * y) / (w.z() * w.z())) - 1) / 2;
    //! [ex-06.5]
}

Real Ggx::transmissionG(const Vec3& wo, const Vec3& wi) const {
    const Real o = 1 + lambda(wo);
    const Real i = 1 + lambda(wi);
    if (!std::isfinite(o + i)) return 0;
    // Heitz et al. 2016: Euler's B(o, i) by three Γ.
    return std::exp(logGamma(o) + logGamma(i) - logGamma(o + i));
}

Vec3 Ggx::sampleVisible(const Vec3& wo, const Vec2& u) const {
    //! [ex-06.6]
    // Dupuy, Benyoub 2023. Stretched, the ellipsoid is a hemisphere. A ball reflects parallel light evenly into all
    // directions: so those of the reflected rays that go up are a spherical cap, from which a direction is easily
    // picked.
    const Vec3 stretched = Vec3(alphaX_ * wo.x(), alphaY_ * wo.y(), wo.z()).normalized();
    const Real angle = 2 * pi * u.x();
    const Real z = (1 - u.y()) * (1 + stretched.z()) - stretched.z();
    const Real r = std::sqrt(std::max(Real(0), 1 - z * z));
    const Vec3 half = Vec3(r * std::cos(angle), r * std::sin(angle), z) + stretched;
    return Vec3(alphaX_ * half.x(), alphaY_ * half.y(), half.z()).normalized();
    //! [ex-06.6]
}

Real Ggx::pdfVisible(const Vec3& wo, const Vec3& wm) const {
    // PBR, 4th ed., eq. 9.23; Heitz 2018, eq. 3.
    return G1(wo) * D(wm) * std::max(Real(0), wo.dot(wm)) / wo.z();
}

Vec3 Ggx::sampleAll(const Vec2& u) const {
    // Walter 2007, eq. 35 and 36, with two roughnesses.
    const Real steep = std::sqrt(u.x() / (1 - u.x()));
    const Real angle = 2 * pi * u.y();
    return Vec3(alphaX_ * steep * std::cos(angle), alphaY_ * steep * std::sin(angle), 1).normalized();
}

}  // namespace caustic
