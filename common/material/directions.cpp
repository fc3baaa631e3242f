#include "material/directions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

// PBR, 4th ed., eq. 9.1.
Vec3 reflected(const Vec3& wo, const Vec3& n) { return 2 * wo.dot(n) * n - wo; }

std::optional<Vec3> refracted(const Vec3& wo, const Vec3& n, Real eta) {
    //! [ex-05.2]
    const Real cosO = wo.dot(n);
    // PBR, 4th ed., eq. 9.2: Snell's law.
    const Real sinSquaredI = std::max(Real(0), 1 - cosO * cosO) / (eta * eta);
    if (sinSquaredI >= 1) return std::nullopt;
    const Real cosI = std::sqrt(1 - sinSquaredI);
    return Vec3((cosO / eta - cosI) * n - wo / eta).normalized();
    //! [ex-05.2]
}

}  // namespace caustic
