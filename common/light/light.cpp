#include "light/light.h"

namespace caustic {

Real Light::pdfW(const Vec3&, const SurfacePoint&) const { return 0; }

Real Light::pdfW(const Vec3&, const Vec3&) const { return 0; }

Color Light::Le(const SurfacePoint&, const Vec3&) const { return Color::Zero(); }

Color Light::Le(const Ray&) const { return Color::Zero(); }

}  // namespace caustic
