#include "material/shading_frame.h"

#include <Eigen/Geometry>

namespace caustic {

ShadingFrame ShadingFrame::at(const Hit& hit, Real iorAbove, Real iorBelow) {
    const Vec3 along = hit.dpdu - hit.dpdu.dot(hit.ns) * hit.ns;
    const Real length = along.norm();
    // At a pole dpdu vanishes, and along ns it has no direction within the surface: any tangents will do.
    if (!(length > 1e-8 * hit.dpdu.norm())) return {Frame::around(hit.ns), hit.ng, iorAbove, iorBelow};
    const Vec3 s = along / length;
    return {{s, hit.ns.cross(s), hit.ns}, hit.ng, iorAbove, iorBelow};
}

}  // namespace caustic
