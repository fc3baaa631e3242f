#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "math/bounds.h"
#include "math/ray.h"

namespace caustic {

/// A point near a ray.
struct BeamPoint {
    std::uint32_t place = 0;   ///< where the tree keeps it
    Real t = 0;                ///< where the ray is nearest to it, in lengths of the direction
    Real squaredDistance = 0;  ///< from there, m²
};

/// A piece of a ray with a radius.
struct Beam {
    /// The foot of the perpendicular from a point to the ray, and how far that is.
    BeamPoint nearest(std::uint32_t place, const Vec3& point) const {
        const Vec3 way = point - ray.origin;
        const Real t = way.dot(ray.direction) / ray.direction.squaredNorm();
        return {place, t, (way - t * ray.direction).squaredNorm()};
    }
    /// Whether such a point belongs to it: within the radius, and beside the ray, not before or behind it.
    bool holds(const BeamPoint& point) const {
        return point.squaredDistance <= radius * radius && ray.reaches(point.t);
    }

    Ray ray;          ///< the piece, from tMin to tMax
    Real radius = 0;  ///< m, at least 0
};

/// A tree of points that says which of them lie along a beam: all within a radius of a ray, in one question, instead of
/// small steps along the ray with a question at each.
///
/// Each node has eight children and knows their boxes; all leaves are on one level, so children are found by
/// arithmetic. A ray is near a point if it meets the box, made larger by the radius, of every node above it. A point's
/// place is where the tree keeps it, as with PointKdTree. Source: Jarosz, Zwicker, Jensen 2008, The Beam Radiance
/// Estimate for Volumetric Photon Mapping, Computer Graphics Forum 27(2), section 5.
class PointBeamTree {
public:
    /// @throws InputError when a coordinate isn't finite or beyond 1e150, or there are 2³² points or more
    explicit PointBeamTree(std::span<const Vec3> points);

    /// How many points there are.
    std::size_t size() const { return points_.size(); }
    /// By place: which point of the given list it is.
    std::span<const std::uint32_t> order() const { return order_; }
    /// By place: where it is.
    const Vec3& point(std::size_t place) const { return points_[place]; }

    /// Calls visit(const BeamPoint&) for each point that the beam holds, once, in no particular order.
    template <typename Visit>
    void along(const Beam& beam, const Visit& visit) const {
        if (points_.empty() || !(beam.radius >= 0)) return;
        const BeamSlabs slabs(beam, box_);
        if (slabs.meets(box_)) look(0, 0, 0, size(), beam, slabs, visit);
    }

private:
    static constexpr std::size_t width = 8;
    static constexpr std::size_t mostInLeaf = 16;

    // The boxes of a node's children: lower x y z, upper x y z.
    struct Node {
        std::array<std::array<Real, width>, 6> rows;
    };
    // A beam, ready to be tested against boxes.
    class BeamSlabs {
    public:
        BeamSlabs(const Beam& beam, const Bounds3& all);
        bool meets(const Bounds3& box) const;
        // A bit for each child whose box it meets.
        unsigned meets(const Node& node) const;

    private:
        std::array<Real, 3> low_;   // origin − radius: what a box's lower side is compared with
        std::array<Real, 3> high_;  // origin + radius
        std::array<Real, 3> inverse_;
        Real tMin_;
        Real tMax_;
    };
    struct Item;

    // Where child i of a range of points begins.
    static std::size_t cut(std::size_t begin, std::size_t end, std::size_t i) {
        return begin + (end - begin) * i / width;
    }

    Bounds3 build(std::span<Item> items, std::size_t node, int level, std::size_t begin, std::size_t end);

    template <typename Visit>
    void look(std::size_t node, int level, std::size_t begin, std::size_t end, const Beam& beam, const BeamSlabs& slabs,
              const Visit& visit) const {
        if (level == levels_) {
            for (std::size_t place = begin; place < end; ++place) {
                const BeamPoint point = beam.nearest(static_cast<std::uint32_t>(place), points_[place]);
                if (beam.holds(point)) visit(point);
            }
            return;
        }
        const unsigned met = slabs.meets(nodes_[node]);
        for (std::size_t i = 0; i < width; ++i) {
            if ((met >> i & 1U) != 0)
                look(width * node + 1 + i, level + 1, cut(begin, end, i), cut(begin, end, i + 1), beam, slabs, visit);
        }
    }

    std::vector<Node> nodes_;  // node k has the children 8k + 1 to 8k + 8; leaves are none
    int levels_ = 0;           // of nodes above the leaves
    Bounds3 box_;
    std::vector<Vec3> points_;
    std::vector<std::uint32_t> order_;
};

}  // namespace caustic
