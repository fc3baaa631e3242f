#include "figures/lit_color.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace caustic {

Color litColor(const Hit& hit, const Vec3& wo, const Vec3& up, const Color& body) {
    const Vec3 side = up.cross(wo).normalized();
    const Vec3 lamp = (wo + 0.9 * up - 0.7 * side).normalized();
    const Vec3 normal = hit.ns.dot(wo) < 0 ? Vec3(-hit.ns) : hit.ns;
    const Real diffuse = 0.22 + 0.78 * std::max(Real(0), normal.dot(lamp));
    const Real shine = 0.5 * std::pow(std::max(Real(0), normal.dot((lamp + wo).normalized())), 80);
    return diffuse * body * (1 - shine) + shine;
}

}  // namespace caustic
