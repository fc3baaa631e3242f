#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "accel/float8.h"
#include "accel/nearest_points.h"
#include "math/bounds.h"
#include "math/vector.h"

namespace caustic {

/// A KD-tree of points: which of them are nearest, and which lie within a radius.
///
/// Points are kept eight to a leaf, and a complete binary tree in an array stands over the leaves: children are found
/// by arithmetic, nothing is stored but planes. Planes and leaves are float, relative to the points' box. They only
/// nominate candidates, with a margin for all rounding; which points are found is decided in Real, so answers are those
/// of brute force. A point's place is where the tree keeps it: neighbours in space have places near each other, so
/// whatever belongs to points is best kept in that order, too.
/// Source: Bentley 1975, Multidimensional Binary Search Trees; Friedman, Bentley, Finkel 1977; distances to cells:
/// Arya, Mount 1993, Algorithms for Fast Vector Quantization.
class PointKdTree {
public:
    /// @throws InputError when a coordinate isn't finite or beyond 1e150, or there are 2³² points or more
    explicit PointKdTree(std::span<const Vec3> points);

    /// How many points there are.
    std::size_t size() const { return points_.size(); }
    /// By place: which point of the given list it is.
    std::span<const std::uint32_t> order() const { return order_; }
    /// By place: where it is.
    const Vec3& point(std::size_t place) const { return points_[place]; }
    /// Bytes that it takes.
    std::size_t memory() const;

    /// Finds the k nearest points; fewer if there are no more within the radius.
    /// @param radius  points farther away don't count; may be infinite
    /// @param found   set to what is found: places
    /// @param counts  bool(std::uint32_t place): only points for which it holds count
    template <typename Counts>
    void nearest(const Vec3& query, std::size_t k, Real radius, NearestPoints& found, const Counts& counts) const {
        found.start(k, radius >= 0 ? radius * radius : -1);
        search(query, found.mostSquared(), [&found, &counts](const NearPoint& point) {
            if (counts(point.place)) found.offer(point);
            return found.mostSquared();
        });
    }

    /// The same, all points counting.
    void nearest(const Vec3& query, std::size_t k, Real radius, NearestPoints& found) const {
        nearest(query, k, radius, found, [](std::uint32_t) { return true; });
    }

    /// Calls visit(const NearPoint&) for each point within a radius, the border included, in no particular order.
    template <typename Visit>
    void within(const Vec3& query, Real radius, const Visit& visit) const {
        const Real mostSquared = radius >= 0 ? radius * radius : -1;
        search(query, mostSquared, [&visit, mostSquared](const NearPoint& point) {
            visit(point);
            return mostSquared;
        });
    }

private:
    static constexpr std::uint32_t leafSize = 8;

    struct Plane {
        float at;
        std::uint32_t axis;
    };
    // Unused lanes hold NaN, which is no nearer than anything.
    struct Leaf {
        std::array<Float8, 3> coordinate;
    };
    // A cell that waits: how far it is from the query, axis by axis, squared.
    struct Waiting {
        std::uint32_t node;
        std::array<float, 3> squared;

        float distance() const { return squared[0] + squared[1] + squared[2]; }
    };
    // A query in the leaves' units, and how far their distances may be off.
    struct FloatQuery {
        std::array<float, 3> at;
        Real scale;   // squared units a squared metre
        Real margin;  // squared units

        // What a point within the distance is at most away from the query, in float.
        float reach(Real mostSquared) const;
    };
    struct Item;

    FloatQuery toFloat(const Vec3& query) const;
    void build(std::span<Item> items, std::uint32_t node, std::uint32_t firstLeaf, std::uint32_t leaves);

    // Calls onPoint(const NearPoint&) for each point within a distance; it answers what the distance is from now on.
    template <typename OnPoint>
    void search(const Vec3& query, Real mostSquared, const OnPoint& onPoint) const;

    std::vector<Plane> planes_;    // node i has the children 2i + 1 and 2i + 2; behind the planes come the leaves
    std::vector<Leaf> leaves_;     // from left to right
    std::uint32_t lastLevel_ = 0;  // its first node
    std::vector<Vec3> points_;
    std::vector<std::uint32_t> order_;
    Vec3 center_ = Vec3::Zero();
    Real scale_ = 1;  // a power of two: units a metre
};

template <typename OnPoint>
void PointKdTree::search(const Vec3& query, Real mostSquared, const OnPoint& onPoint) const {
    if (points_.empty() || !(mostSquared >= 0)) return;
    const FloatQuery q = toFloat(query);
    const auto planes = static_cast<std::uint32_t>(planes_.size());
    const auto leaves = static_cast<std::uint32_t>(leaves_.size());
    float reach = q.reach(mostSquared);
    std::array<Waiting, 32> stack;
    std::size_t waiting = 0;
    Waiting cell = {0, {0, 0, 0}};
    while (true) {
        while (cell.node < planes) {
            const Plane plane = planes_[cell.node];
            const float beyond = q.at[plane.axis] - plane.at;
            const std::uint32_t right = beyond >= 0 ? 1 : 0;
            Waiting farther = {2 * cell.node + 2 - right, cell.squared};
            farther.squared[plane.axis] = beyond * beyond;
            cell.node = 2 * cell.node + 1 + right;
            if (farther.distance() <= reach) stack[waiting++] = farther;
        }
        const std::uint32_t leaf = cell.node >= lastLevel_ ? cell.node - lastLevel_ : cell.node + leaves - lastLevel_;
        const Float8 dx = leaves_[leaf].coordinate[0] - q.at[0];
        const Float8 dy = leaves_[leaf].coordinate[1] - q.at[1];
        const Float8 dz = leaves_[leaf].coordinate[2] - q.at[2];
        const Float8 squared = dx * dx + dy * dy + dz * dz;
        for (unsigned lanes = lanesOf(squared <= reach); lanes != 0; lanes &= lanes - 1) {
            const std::uint32_t place = leafSize * leaf + static_cast<std::uint32_t>(std::countr_zero(lanes));
            const Real exact = (points_[place] - query).squaredNorm();
            if (exact <= mostSquared) mostSquared = onPoint(NearPoint{place, exact});
        }
        reach = q.reach(mostSquared);
        do {
            if (waiting == 0) return;
            cell = stack[--waiting];
        } while (!(cell.distance() <= reach));
    }
}

}  // namespace caustic
