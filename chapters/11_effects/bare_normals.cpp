#include "bare_normals.h"

namespace caustic {

Vec3 bareNormal(const Hit& at, const Vec3& local) {
    const Vec3 along = at.dpdu - at.dpdu.dot(at.ns) * at.ns;
    if (!(along.norm() > 1e-8 * at.dpdu.norm())) return at.ns;
    const Vec3 s = along.normalized();
    return (local.x() * s + local.y() * at.handedness() * at.ns.cross(s) + local.z() * at.ns).normalized();
}

std::optional<Hit> BareNormals::intersect(const Ray& ray) const {
    std::optional<Hit> hit = shape_->intersect(ray);
    if (hit) hit->ns = bareNormal(*hit, map_->at(hit->uv));
    return hit;
}

}  // namespace caustic
