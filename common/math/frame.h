#pragma once

#include <cmath>

#include "math/vector.h"

namespace caustic {

/// Three orthonormal axes with s × t = n.
struct Frame {
    Vec3 s = Vec3::UnitX();
    Vec3 t = Vec3::UnitY();
    Vec3 n = Vec3::UnitZ();

    /// A frame around a unit vector, without a branch that could lose precision for some of them.
    /// Source: Duff et al. 2017, Building an Orthonormal Basis, Revisited, JCGT 6(1), listing 3.
    static Frame around(const Vec3& n) {
        const Real sign = std::copysign(Real(1), n.z());
        const Real a = -1 / (sign + n.z());
        const Real b = n.x() * n.y() * a;
        return {Vec3(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()), Vec3(b, sign + n.y() * n.y() * a, -n.y()),
                n};
    }

    /// A vector's components along s, t, n, and the vector that has these components.
    Vec3 toLocal(const Vec3& world) const { return {s.dot(world), t.dot(world), n.dot(world)}; }
    Vec3 toWorld(const Vec3& local) const { return local.x() * s + local.y() * t + local.z() * n; }
};

}  // namespace caustic
