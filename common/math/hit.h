#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "math/surface_point.h"

namespace caustic {

/// Names an object of a scene: an index into its tables of materials, lights and media.
using ObjectId = std::int32_t;

/// No enclosing instance has named the object yet.
inline constexpr ObjectId noObject = -1;

/// Where a ray meets a shape: everything that shading may ask for, and nothing about material.
struct Hit : SurfacePoint {
    Real t = 0;  ///< in lengths of the ray's direction

    /// Unit shading normal, on the same side as ng. Differs from it on meshes with normals of their own only.
    Vec3 ns = Vec3::UnitZ();

    /// Derivatives of the point by u and v: tangent, neither unit nor orthogonal in general. dpdu × dpdv points along
    /// ng, or against it: in a mirrored instance, and where a mesh's uvs run clockwise (handedness). Either may vanish
    /// where the parametrisation does (a sphere's poles).
    Vec3 dpdu = Vec3::UnitX();
    Vec3 dpdv = Vec3::UnitY();

    ObjectId object = noObject;  ///< given by the nearest enclosing instance that sets one

    /// 1 when u, v and ng are right-handed; −1 when they are left-handed, so that whatever is laid on the surface by u
    /// and v is seen mirrored from the side that ng points to.
    Real handedness() const { return dpdu.cross(dpdv).dot(ng) < 0 ? -1 : 1; }
};

}  // namespace caustic
