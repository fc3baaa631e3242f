#pragma once

#include <optional>

#include "math/bounds.h"
#include "math/ray.h"
#include "surface/indexed_triangles.h"

namespace caustic {

/// Boxes in boxes around triangles, halved at the median: just enough to give a tessellated surface a fair chance in
/// the speed chart. Chapter 04 shows how it is done well.
class TriangleTree {
public:
    /// @param triangles  at least one
    explicit TriangleTree(IndexedTriangles triangles);

    /// t of the nearest triangle with tMin < t < tMax.
    std::optional<Real> intersect(const Ray& ray) const;

    /// How many triangles there are.
    std::size_t size() const { return mesh_.triangles.size(); }

private:
    struct Node {
        Bounds3 box;
        std::size_t first;  // triangle of a leaf, or second child; the first child is the next node
        std::size_t count;  // triangles of a leaf; 0 of an inner node
    };

    std::size_t build(std::size_t first, std::size_t last);
    Bounds3 boundsOf(std::size_t triangle) const;

    IndexedTriangles mesh_;
    std::vector<Node> nodes_;
};

}  // namespace caustic
