#include "mesh_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mesh/mesh_file.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"

namespace caustic {

namespace {

// Six times the volume that the triangles enclose; negative when they face inwards.
Real signedVolume(const MeshData& mesh) {
    Real sum = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.corners(i);
        sum += a.dot(b.cross(c));
    }
    return sum;
}

void turnInsideOut(MeshData& mesh) {
    for (auto* const corners : {&mesh.triangles, &mesh.normalCorners, &mesh.uvCorners}) {
        for (MeshData::Corners& one : *corners) std::swap(one[1], one[2]);
    }
    for (Vec3& normal : mesh.normals) normal = -normal;
}

// A corner whose smooth normal is further than this from its triangle's has an edge between the two: a cube's are 55°
// off.
constexpr Real creaseAngle = 50 * std::numbers::pi / 180;

// Smooth normals, but not over edges. A mirror that is smoothed around an edge would reflect into itself.
MeshData withSmoothNormals(MeshData mesh) {
    mesh = withVertexNormals(std::move(mesh), NormalWeight::Angle);
    for (const std::uint32_t triangle : trianglesWithArea(mesh)) {
        const Vec3 own = twiceArea(mesh, triangle).normalized();
        const auto ownNormal = static_cast<std::uint32_t>(mesh.normals.size());
        for (std::uint32_t& corner : mesh.normalCorners[triangle]) {
            if (mesh.normals[corner].dot(own) < std::cos(creaseAngle)) corner = ownNormal;
        }
        if (std::ranges::count(mesh.normalCorners[triangle], ownNormal) > 0) mesh.normals.push_back(own);
    }
    return mesh;
}

}  // namespace

std::shared_ptr<const Shape> loadShape(const std::filesystem::path& file) {
    MeshData mesh = loadMesh(file);
    if (signedVolume(mesh) < 0) turnInsideOut(mesh);
    if (mesh.normals.empty()) mesh = withSmoothNormals(std::move(mesh));
    return std::make_shared<TriangleMesh>(std::move(mesh));
}

}  // namespace caustic
