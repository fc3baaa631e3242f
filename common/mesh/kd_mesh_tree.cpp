#include "mesh/kd_mesh_tree.h"

#include <utility>

#include "mesh/nearest_triangle.h"
#include "mesh/triangle_clip.h"

namespace caustic {

namespace {

KdTree plant(const MeshData& mesh, const std::vector<std::uint32_t>& triangles, const KdRule& rule) {
    std::vector<Bounds3> boxes;
    boxes.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) boxes.push_back(mesh.bounds(triangle));
    const auto clip = [&](std::uint32_t item, const Bounds3& inside) {
        const auto [a, b, c] = mesh.corners(triangles[item]);
        return clippedTriangleBounds(a, b, c, inside);
    };
    return KdTree(std::move(boxes), rule, clip);
}

}  // namespace

BruteForceMesh::BruteForceMesh(std::shared_ptr<const MeshData> mesh)
    : mesh_(std::move(mesh)), triangles_(trianglesWithArea(*mesh_)) {}

std::optional<MeshHit> BruteForceMesh::intersect(const Ray& ray) const {
    NearestTriangle search(*mesh_, ray);
    for (const std::uint32_t triangle : triangles_) search.test(triangle);
    return search.nearest();
}

bool BruteForceMesh::occluded(const Ray& ray) const {
    NearestTriangle search(*mesh_, ray);
    for (const std::uint32_t triangle : triangles_) {
        if (search.test(triangle)) return true;
    }
    return false;
}

std::optional<MeshHit> BruteForceMesh::intersectCounted(const Ray& ray, MeshWork& work) const {
    work.tests += triangles_.size();
    return intersect(ray);
}

KdMeshTree::KdMeshTree(std::shared_ptr<const MeshData> mesh, const KdRule& rule)
    : mesh_(std::move(mesh)), triangles_(trianglesWithArea(*mesh_)), tree_(plant(*mesh_, triangles_, rule)) {}

std::optional<MeshHit> KdMeshTree::intersect(const Ray& ray) const {
    NearestTriangle search(*mesh_, ray);
    Ray shortened = ray;
    tree_.traverse(shortened, [&](std::uint32_t item) {
        if (search.test(triangles_[item])) shortened.tMax = search.tMax();
        return false;
    });
    return search.nearest();
}

bool KdMeshTree::occluded(const Ray& ray) const {
    NearestTriangle search(*mesh_, ray);
    Ray whole = ray;
    tree_.traverse(whole, [&](std::uint32_t item) { return search.test(triangles_[item]); });
    return search.nearest().has_value();
}

std::optional<MeshHit> KdMeshTree::intersectCounted(const Ray& ray, MeshWork& work) const {
    NearestTriangle search(*mesh_, ray);
    Ray shortened = ray;
    const auto test = [&](std::uint32_t item) {
        ++work.tests;
        if (search.test(triangles_[item])) shortened.tMax = search.tMax();
        return false;
    };
    tree_.traverse(shortened, test, [&](const KdNode<Real>&) { ++work.nodes; });
    return search.nearest();
}

MeshTreeSize KdMeshTree::size() const {
    const KdNodes<Real>& built = tree_.nodes();
    return {tree_.memory(), built.nodes.size(), built.items.size(), built.depth, built.work};
}

}  // namespace caustic
