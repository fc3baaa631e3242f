#include "measures/triangle_tree.h"

#include <algorithm>
#include <array>

#include "math/slabs.h"
#include "shape/watertight.h"

namespace caustic {

namespace {

constexpr std::size_t mostInLeaf = 4;

}  // namespace

TriangleTree::TriangleTree(IndexedTriangles triangles) : mesh_(std::move(triangles)) {
    build(0, mesh_.triangles.size());
}

Bounds3 TriangleTree::boundsOf(std::size_t triangle) const {
    Bounds3 box;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) box.extend(mesh_.vertices[vertex]);
    return box;
}

std::size_t TriangleTree::build(std::size_t first, std::size_t last) {
    const std::size_t place = nodes_.size();
    nodes_.push_back({{}, first, last - first});
    Bounds3 box;
    Bounds3 centres;
    for (std::size_t i = first; i < last; ++i) {
        box.extend(boundsOf(i));
        centres.extend(boundsOf(i).center());
    }
    nodes_[place].box = box;
    if (last - first <= mostInLeaf) return place;
    int axis = 0;
    centres.sizes().maxCoeff(&axis);
    const auto centreOf = [&](const std::array<std::uint32_t, 3>& triangle) {
        return mesh_.vertices[triangle[0]][axis] + mesh_.vertices[triangle[1]][axis] +
               mesh_.vertices[triangle[2]][axis];
    };
    const auto at = [&](std::size_t i) { return mesh_.triangles.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t middle = (first + last) / 2;
    std::nth_element(at(first), at(middle), at(last),
                     [&](const auto& a, const auto& b) { return centreOf(a) < centreOf(b); });
    build(first, middle);
    const std::size_t second = build(middle, last);
    nodes_[place].first = second;
    nodes_[place].count = 0;
    return place;
}

std::optional<Real> TriangleTree::intersect(const Ray& ray) const {
    ShearedRay sheared(ray);
    std::optional<Real> nearest;
    std::array<std::size_t, 64> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::size_t place = waiting[--count];
        const Node& node = nodes_[place];
        if (!mayMeet(node.box, sheared.ray)) continue;
        if (node.count == 0) {
            waiting[count++] = node.first;
            waiting[count++] = place + 1;
            continue;
        }
        for (std::size_t i = node.first; i < node.first + node.count; ++i) {
            const auto [a, b, c] = mesh_.triangles[i];
            const auto hit = intersectWatertight(sheared, mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
            if (hit) nearest = sheared.ray.tMax = hit->t;
        }
    }
    return nearest;
}

}  // namespace caustic
