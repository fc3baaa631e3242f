#pragma once

#include "math/frame.h"
#include "math/hit.h"

namespace caustic {

/// What a BSDF knows of the place: both normals, tangents, and what is on either side.
struct ShadingFrame {
    Frame frame;              ///< n is the shading normal, s along dpdu as far as that goes
    Vec3 ng = Vec3::UnitZ();  ///< unit geometric normal, on the same side
    Real iorAbove = 1;        ///< index of refraction on the side that ng points to
    Real iorBelow = 1;        ///< index of refraction on the other side

    /// The frame at a hit: tangents along dpdu, unless that vanishes.
    static ShadingFrame at(const Hit& hit, Real iorAbove, Real iorBelow);

    /// 1 when the direction is on ng's side or along the surface, −1 otherwise.
    Real side(const Vec3& direction) const { return direction.dot(ng) >= 0 ? 1 : -1; }

    /// A direction as models see it: z along ns on the given side.
    Vec3 toLocal(const Vec3& world, Real side) const {
        return {frame.s.dot(world), frame.t.dot(world), side * frame.n.dot(world)};
    }
    /// The reverse.
    Vec3 toWorld(const Vec3& local, Real side) const {
        return local.x() * frame.s + local.y() * frame.t + side * local.z() * frame.n;
    }

    /// Index of refraction across the surface over that on the given side.
    Real eta(Real side) const { return side > 0 ? iorBelow / iorAbove : iorAbove / iorBelow; }
};

}  // namespace caustic
