#include "light/point_light.h"

#include <numbers>

#include "core/check.h"
#include "light/direct_from_point.h"
#include "sampling/warp.h"
#include "texture/check_color.h"

namespace caustic {

namespace {

constexpr Real wholeSphere = 4 * std::numbers::pi;

}  // namespace

PointLight::PointLight(const Vec3& position, const Color& intensity) : position_(position), intensity_(intensity) {
    for (const Real coordinate : position) checkFinite(coordinate, "point light's position");
    checkNotNegative(intensity, "point light's intensity");
}

std::optional<DirectSample> PointLight::sampleDirect(const SurfacePoint& from, const Vec2&) const {
    return directFromPoint(from, position_, intensity_);
}

std::optional<EmissionSample> PointLight::sampleEmission(const Vec2&, const Vec2& uDirection) const {
    const Vec3 direction = uniformSphere(uDirection);
    // PBR, 4th ed., A.5.2: uniform over the sphere.
    return EmissionSample{{position_, direction}, direction, intensity_, 1, 1 / wholeSphere};
}

// As in sampleEmission.
EmissionPdf PointLight::pdfEmission(const SurfacePoint&, const Vec3&) const { return {0, 1 / wholeSphere}; }

Color PointLight::power() const { return wholeSphere * intensity_; }

}  // namespace caustic
