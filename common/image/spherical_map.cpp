#include "image/spherical_map.h"

#include <cmath>
#include <numbers>

namespace caustic {

using std::numbers::pi;

Vec2 sphericalToUv(const Vec3& direction) {
    // atan2 and not acos(z): near the poles the cosine has lost the angle.
    const Real aside = std::hypot(direction.x(), direction.y());
    const Real azimuth = aside > 0 ? std::atan2(direction.y(), direction.x()) : 0;
    return {Real(0.5) - azimuth / (2 * pi), std::atan2(aside, direction.z()) / pi};
}

Vec3 uvToSpherical(const Vec2& uv) {
    const Real azimuth = (Real(0.5) - uv.x()) * 2 * pi;
    const Real theta = uv.y() * pi;
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

Color lookUpSpherical(const Image& panorama, const Vec3& direction) {
    const Vec2 uv = sphericalToUv(direction);
    return panorama.bilinear(uv.x() * panorama.width(), uv.y() * panorama.height(), Wrap::Repeat, Wrap::Clamp);
}

}  // namespace caustic
