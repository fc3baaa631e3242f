#include "mesh/mesh_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/check.h"

namespace caustic {

namespace {

// @param what  as in "normal"
void checkCorners(const std::vector<MeshData::Corners>& all, std::size_t count, bool noneIsFine,
                  const std::string& what) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const std::uint32_t corner : all[i]) {
            const bool known = corner < count || (noneIsFine && corner == MeshData::none);
            checkArgument(known, "triangle " + std::to_string(i), std::to_string(corner),
                          "names a " + what + " that isn't there; there are " + std::to_string(count));
        }
    }
}

}  // namespace

void checkMesh(const MeshData& mesh) {
    checkArgument(!mesh.triangles.empty(), "mesh", "0 triangles", "needs at least one");
    for (const auto* corners : {&mesh.normalCorners, &mesh.uvCorners}) {
        checkArgument(corners->empty() || corners->size() == mesh.triangles.size(), "mesh",
                      std::to_string(corners->size()) + " triples", "needs one for each triangle, or none");
    }
    for (const Vec3& position : mesh.positions) {
        for (const Real coordinate : position) checkFinite(coordinate, "mesh's vertex");
    }
    for (const Vec3& normal : mesh.normals) {
        for (const Real coordinate : normal) checkFinite(coordinate, "mesh's normal");
    }
    for (const Vec2& uv : mesh.uvs) {
        for (const Real coordinate : uv) checkFinite(coordinate, "mesh's uv");
    }
    checkCorners(mesh.triangles, mesh.positions.size(), false, "vertex");
    checkCorners(mesh.normalCorners, mesh.normals.size(), true, "normal");
    checkCorners(mesh.uvCorners, mesh.uvs.size(), true, "uv");
}

Bounds3 boundsOf(const MeshData& mesh) {
    Bounds3 box;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) box.extend(mesh.bounds(triangle));
    return box;
}

std::size_t unusedVertices(const MeshData& mesh) {
    std::vector<bool> used(mesh.positions.size());
    for (const MeshData::Corners& corners : mesh.triangles) {
        for (const std::uint32_t corner : corners) used[corner] = true;
    }
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

Vec3 twiceArea(const MeshData& mesh, std::uint32_t triangle) {
    const auto [a, b, c] = mesh.corners(triangle);
    return (b - a).cross(c - a);
}

std::vector<std::uint32_t> trianglesWithArea(const MeshData& mesh) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Real length = twiceArea(mesh, triangle).norm();
        if (length >= std::numeric_limits<Real>::min() && std::isfinite(length)) found.push_back(triangle);
    }
    return found;
}

}  // namespace caustic
