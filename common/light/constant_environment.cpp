#include "light/constant_environment.h"

#include <numbers>

#include "math/frame.h"
#include "math/spawn.h"
#include "sampling/warp.h"
#include "texture/check_color.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

}  // namespace

ConstantEnvironment::ConstantEnvironment(const Color& radiance) : radiance_(radiance) {
    checkNotNegative(radiance, "environment's radiance");
}

void ConstantEnvironment::prepare(const Bounds3& scene) {
    if (scene.isEmpty()) return;
    center_ = scene.center();
    radius_ = scene.diagonal().norm() / 2;
}

std::optional<DirectSample> ConstantEnvironment::sampleDirect(const SurfacePoint& from, const Vec2& u) const {
    const Vec3 wi = uniformSphere(u);
    return DirectSample{wi, radiance_, pdfW(from.point, wi), spawnRay(from, wi), {}};
}

// PBR, 4th ed., A.5.2: uniform over the sphere.
Real ConstantEnvironment::pdfW(const Vec3&, const Vec3&) const { return 1 / (4 * pi); }

std::optional<EmissionSample> ConstantEnvironment::sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const {
    const Vec3 direction = uniformSphere(uDirection);
    const Frame frame = Frame::around(direction);
    const Vec2 disc = radius_ * concentricDisc(uPlace);
    const Vec3 origin = center_ - radius_ * direction + disc.x() * frame.s + disc.y() * frame.t;
    // PBR, 4th ed., 12.5: uniform over the disc that the scene shows in this direction, which is uniform itself.
    return EmissionSample{{origin, direction}, direction, radiance_, 1 / (pi * radius_ * radius_), 1 / (4 * pi)};
}

EmissionPdf ConstantEnvironment::pdfEmission(const SurfacePoint&, const Vec3&) const {
    // As in sampleEmission.
    return {1 / (pi * radius_ * radius_), 1 / (4 * pi)};
}

Color ConstantEnvironment::Le(const Ray&) const { return radiance_; }

Color ConstantEnvironment::power() const { return 4 * pi * pi * radius_ * radius_ * radiance_; }

}  // namespace caustic
