#include "mesh_shape.h"

#include <Eigen/Geometry>
#include <utility>

#include "shape/mesh_file.h"
#include "shape/triangle_mesh.h"
#include "shape/vertex_normals.h"

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

}  // namespace

std::shared_ptr<const Shape> loadShape(const std::filesystem::path& file) {
    MeshData mesh = loadMesh(file);
    if (signedVolume(mesh) < 0) turnInsideOut(mesh);
    if (mesh.normals.empty()) mesh = withVertexNormals(std::move(mesh), NormalWeight::Angle);
    return std::make_shared<TriangleMesh>(std::move(mesh));
}

}  // namespace caustic
