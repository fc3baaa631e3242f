#include "figures/mesh_view.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace caustic {

RayView viewOf(const Bounds3& box, const Vec3& from) {
    const Real radius = box.diagonal().norm() / 2;
    return {box.center() + 4 * radius * from.normalized(), box.center(), Vec3::UnitY(), 1.45 * radius};
}

Color plaster(const Hit& hit, const Vec3& wo) {
    const Vec3 normal = hit.ng.dot(wo) < 0 ? Vec3(-hit.ns) : hit.ns;
    const Real key = std::max(Real(0), normal.dot(Vec3(-0.5, 0.8, 0.6).normalized()));
    const Real fill = std::max(Real(0), normal.dot(Vec3(0.9, 0.1, 0.5).normalized()));
    const Real sky = 0.5 + 0.5 * normal.y();
    return Color(0.62, 0.56, 0.48) * key + Color(0.10, 0.13, 0.18) * fill + Color(0.08, 0.09, 0.11) * sky;
}

}  // namespace caustic
