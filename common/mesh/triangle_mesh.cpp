#include "mesh/triangle_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "core/check.h"
#include "core/not_implemented.h"
#include "math/stable_norm.h"

namespace caustic {

namespace {

std::shared_ptr<const MeshData> checked(MeshData mesh) {
    checkMesh(mesh);
    return std::make_shared<const MeshData>(std::move(mesh));
}

DiscreteDistribution areasOf(const MeshData& mesh) {
    const std::vector<std::uint32_t> solid = trianglesWithArea(mesh);
    checkArgument(!solid.empty(), "mesh", std::to_string(mesh.triangles.size()) + " triangles",
                  "needs one that has an area");
    std::vector<Real> areas(mesh.triangles.size(), 0);
    for (const std::uint32_t triangle : solid) areas[triangle] = twiceArea(mesh, triangle).norm() / 2;
    return DiscreteDistribution(areas);
}

// Tangents that make u and v what the corners say; the triangle's edges when these say nothing.
void setSurfaceCoordinates(const MeshData& mesh, const MeshHit& at, Hit& hit) {
    const auto [a, b, c] = mesh.corners(at.triangle);
    hit.uv = {at.b1, at.b2};
    hit.dpdu = b - a;
    hit.dpdv = c - a;
    if (mesh.uvCorners.empty()) return;
    const MeshData::Corners& corners = mesh.uvCorners[at.triangle];
    if (std::ranges::count(corners, MeshData::none) > 0) return;
    const Vec2& uv0 = mesh.uvs[corners[0]];
    Eigen::Matrix<Real, 2, 2> edges;
    edges << mesh.uvs[corners[1]] - uv0, mesh.uvs[corners[2]] - uv0;
    hit.uv = uv0 + edges * Vec2(at.b1, at.b2);
    const Real determinant = edges.determinant();
    if (determinant == 0) return;
    const Vec3 dpdu = (edges(1, 1) * (b - a) - edges(1, 0) * (c - a)) / determinant;
    const Vec3 dpdv = (edges(0, 0) * (c - a) - edges(0, 1) * (b - a)) / determinant;
    if (!dpdu.allFinite() || !dpdv.allFinite()) return;
    hit.dpdu = dpdu;
    hit.dpdv = dpdv;
}

}  // namespace

Vec3 interpolatedNormal(const MeshData& mesh, const MeshHit& at, const Vec3& ng) {
    //! [ex-04.5]
    if (mesh.normalCorners.empty()) return ng;
    const MeshData::Corners& corners = mesh.normalCorners[at.triangle];
    const std::array<Real, 3> weights = {1 - at.b1 - at.b2, at.b1, at.b2};
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i] == MeshData::none) return ng;
        // Of unit length first, or the longer normal would win.
        const Vec3& normal = mesh.normals[corners[i]];
        const Real length = stableNorm(normal);
        if (!(length > 0)) return ng;
        sum += weights[i] * (normal / length);
    }
    const Real length = sum.norm();
    if (!(length > 0)) return ng;
    return sum.dot(ng) < 0 ? Vec3(-sum / length) : Vec3(sum / length);
    //! [ex-04.5]
}

TriangleMesh::TriangleMesh(MeshData mesh, MeshTreeKind kind)
    : mesh_(checked(std::move(mesh))), areas_(areasOf(*mesh_)) {
    for (const std::uint32_t triangle : trianglesWithArea(*mesh_)) bounds_.extend(mesh_->bounds(triangle));
    tree_ = plantMeshTree(kind, mesh_);
}

std::optional<Hit> TriangleMesh::intersect(const Ray& ray) const {
    const std::optional<MeshHit> found = tree_->intersect(ray);
    if (!found) return std::nullopt;
    return hitAt(*found);
}

Hit TriangleMesh::hitAt(const MeshHit& found) const {
    const auto [a, b, c] = mesh_->corners(found.triangle);
    Hit hit;
    hit.t = found.t;
    hit.point = (1 - found.b1 - found.b2) * a + found.b1 * b + found.b2 * c;
    hit.ng = (b - a).cross(c - a).normalized();
    hit.ns = interpolatedNormal(*mesh_, found, hit.ng);
    hit.magnitude = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs()).maxCoeff();
    setSurfaceCoordinates(*mesh_, found, hit);
    return hit;
}

std::optional<AreaSample> TriangleMesh::sampleArea(const Vec2& u) const {
    // u.x chooses the triangle; what is left of it within the triangle's share is uniform again.
    const auto [triangle, share] = areas_.choose(u.x());
    const Real size = std::sqrt(share);
    const MeshHit place = {{0, size * (1 - u.y()), size * u.y()}, static_cast<std::uint32_t>(triangle)};
    return AreaSample{hitAt(place), 1 / areas_.sum()};
}

Real TriangleMesh::pdfA(const SurfacePoint&) const { return 1 / areas_.sum(); }

}  // namespace caustic
