#include "material/shading_frame.h"

#include <Eigen/Geometry>
#include <cmath>

namespace caustic {

ShadingFrame ShadingFrame::at(const Hit& hit, Real iorAbove, Real iorBelow) {
    const Vec3 along = hit.dpdu - hit.dpdu.dot(hit.ns) * hit.ns;
    const Real squared = along.squaredNorm();
    // At a pole dpdu vanishes, and along ns it has no direction within the surface: any tangents will do.
    if (!(squared > 1e-16 * hit.dpdu.squaredNorm())) return {Frame::around(hit.ns), hit.ng, iorAbove, iorBelow};
    const Vec3 s = along / std::sqrt(squared);
    return {{s, hit.ns.cross(s), hit.ns}, hit.ng, iorAbove, iorBelow};
}

}  // namespace caustic
