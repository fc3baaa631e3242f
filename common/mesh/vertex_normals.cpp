#include "mesh/vertex_normals.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

namespace {

// Between two edges, also where these are nearly parallel.
Real angleBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

std::vector<Vec3> vertexNormals(const MeshData& mesh, NormalWeight weight) {
    //! [ex-04.6]
    std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Vec3 areaNormal = twiceArea(mesh, triangle);
        const Real length = areaNormal.norm();
        if (!(length > 0)) continue;
        const Vec3 unit = areaNormal / length;
        const auto corners = mesh.corners(triangle);
        for (std::size_t i = 0; i < 3; ++i) {
            Vec3& normal = normals[mesh.triangles[triangle][i]];
            switch (weight) {
                case NormalWeight::Mean:
                    normal += unit;
                    break;
                case NormalWeight::Area:
                    normal += areaNormal;
                    break;
                case NormalWeight::Angle:
                    normal += angleBetween(corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]) * unit;
                    break;
            }
        }
    }
    for (Vec3& normal : normals) {
        const Real length = normal.norm();
        if (length > 0) normal /= length;
    }
    return normals;
    //! [ex-04.6]
}

MeshData withVertexNormals(MeshData mesh, NormalWeight weight) {
    mesh.normals = vertexNormals(mesh, weight);
    mesh.normalCorners = mesh.triangles;
    return mesh;
}

}  // namespace caustic
