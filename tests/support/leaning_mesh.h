#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "mesh/triangle_mesh.h"

namespace caustic::test {

/// The plane through a point, as a large triangle of a smooth mesh: its shading normal leans, the same everywhere.
/// @param ng  unit normal of the plane
/// @param ns  of any length, on the same side
inline std::shared_ptr<const Shape> leaningPlane(const Vec3& point, const Vec3& ng, const Vec3& ns, Real size) {
    const Vec3 s = ng.unitOrthogonal();
    const Vec3 t = ng.cross(s);
    MeshData mesh;
    mesh.positions = {point - size * (s + t), point + size * (3 * s - t), point + size * (3 * t - s)};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {ns};
    mesh.normalCorners = {{0, 0, 0}};
    return std::make_shared<TriangleMesh>(mesh);
}

}  // namespace caustic::test
