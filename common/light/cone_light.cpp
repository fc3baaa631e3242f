#include "light/cone_light.h"

#include <cmath>
#include <numbers>

#include "core/check.h"
#include "light/direct_from_point.h"
#include "sampling/warp.h"
#include "texture/check_color.h"

namespace caustic {

ConeLight::ConeLight(const Vec3& position, const Vec3& axis, Real halfAngle, const Color& intensity)
    : position_(position), intensity_(intensity) {
    for (const Real coordinate : position) checkFinite(coordinate, "cone light's position");
    checkPositive(axis.norm(), "cone light's axis's length");
    checkPositive(halfAngle, "cone light's half angle");
    checkArgument(halfAngle <= std::numbers::pi, "cone light's half angle", formatReal(halfAngle), "must be at most π");
    checkNotNegative(intensity, "cone light's intensity");
    frame_ = Frame::around(axis.normalized());
    cosLimit_ = std::cos(halfAngle);
}

std::optional<DirectSample> ConeLight::sampleDirect(const SurfacePoint& from, const Vec2&) const {
    const auto sample = directFromPoint(from, position_, intensity_);
    if (!sample || !lights(-sample->wi)) return std::nullopt;
    return sample;
}

std::optional<EmissionSample> ConeLight::sampleEmission(const Vec2&, const Vec2& uDirection) const {
    const Vec3 direction = frame_.toWorld(uniformCone(uDirection, cosLimit_));
    // PBR, 4th ed., A.5.4: uniform within the cone.
    return EmissionSample{{position_, direction}, direction, intensity_, 1, 1 / solidAngle()};
}

EmissionPdf ConeLight::pdfEmission(const SurfacePoint&, const Vec3& direction) const {
    // As in sampleEmission.
    return {0, lights(direction) ? 1 / solidAngle() : 0};
}

Color ConeLight::power() const { return solidAngle() * intensity_; }

Real ConeLight::solidAngle() const { return 2 * std::numbers::pi * (1 - cosLimit_); }

}  // namespace caustic
