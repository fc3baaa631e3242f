#include "accel/point_beam_tree.h"

#include <algorithm>
#include <limits>

#include "core/check.h"

namespace caustic {

namespace {

constexpr Real farthest = 1e150;  // squares stay finite

// A direction's component that is smaller than this share of the largest counts as this much, so that its inverse is
// finite.
constexpr Real tiniestShare = 1e-30;

// Boxes are larger by this share of the largest coordinate that the beam meets: more than rounding moves anything.
constexpr Real padding = 0x1p-44;

// Cuts items in two halves of given sizes across their longer side, and again, until there are `parts`.
template <typename Items, typename Cut>
void cutInto(Items items, std::size_t first, std::size_t parts, const Cut& cut) {
    if (parts == 1) return;
    Bounds3 box;
    for (const auto& item : items) box.extend(item.at);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = cut(first + parts / 2) - cut(first);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                     [axis](const auto& a, const auto& b) { return a.at[axis] < b.at[axis]; });
    cutInto(items.first(middle), first, parts / 2, cut);
    cutInto(items.subspan(middle), first + parts / 2, parts / 2, cut);
}

}  // namespace

struct PointBeamTree::Item {
    Vec3 at;
    std::uint32_t index;
};

PointBeamTree::PointBeamTree(std::span<const Vec3> points) {
    checkArgument(points.size() < std::numeric_limits<std::uint32_t>::max(), "points of a tree",
                  std::to_string(points.size()), "takes fewer than 2^32 points");
    std::vector<Item> items(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        checkArgument((points[i].array().abs() <= farthest).all(), "a point's coordinates",
                      formatReal(points[i].x()) + ", " + formatReal(points[i].y()) + ", " + formatReal(points[i].z()),
                      "must be finite and at most 1e150");
        items[i] = {points[i], static_cast<std::uint32_t>(i)};
    }
    std::size_t nodes = 0;
    for (std::size_t leaves = 1; (items.size() + leaves - 1) / leaves > mostInLeaf; leaves *= width) {
        nodes += leaves;
        ++levels_;
    }
    nodes_.resize(nodes);
    box_ = build(items, 0, 0, 0, items.size());
    points_.reserve(items.size());
    order_.reserve(items.size());
    for (const Item& item : items) {
        points_.push_back(item.at);
        order_.push_back(item.index);
    }
}

// Sorts the items of a node, begin to end of all, and says what box they are in.
Bounds3 PointBeamTree::build(std::span<Item> items, std::size_t node, int level, std::size_t begin, std::size_t end) {
    Bounds3 box;
    if (level == levels_) {
        for (std::size_t i = begin; i < end; ++i) box.extend(items[i].at);
        return box;
    }
    cutInto(items.subspan(begin, end - begin), 0, width, [=](std::size_t i) { return cut(begin, end, i); });
    for (std::size_t i = 0; i < width; ++i) {
        const Bounds3 child = build(items, width * node + 1 + i, level + 1, cut(begin, end, i), cut(begin, end, i + 1));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            nodes_[node].rows[axis][i] = child.min()[static_cast<int>(axis)];
            nodes_[node].rows[axis + 3][i] = child.max()[static_cast<int>(axis)];
        }
        box.extend(child);
    }
    return box;
}

PointBeamTree::BeamSlabs::BeamSlabs(const Beam& beam, const Bounds3& all) : tMin_(beam.ray.tMin), tMax_(beam.ray.tMax) {
    const Vec3& origin = beam.ray.origin;
    const Real largest = beam.ray.direction.cwiseAbs().maxCoeff();
    const Real coordinate =
        std::max({origin.cwiseAbs().maxCoeff(), all.min().cwiseAbs().maxCoeff(), all.max().cwiseAbs().maxCoeff()});
    const Real radius = beam.radius + padding * (coordinate + beam.radius);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        low_[i] = origin[axis] + radius;
        high_[i] = origin[axis] - radius;
        const Real component = beam.ray.direction[axis];
        inverse_[i] =
            1 / (std::abs(component) >= tiniestShare * largest ? component
                                                               : std::copysign(tiniestShare * largest, component));
    }
}

bool PointBeamTree::BeamSlabs::meets(const Bounds3& box) const {
    Real enter = tMin_;
    Real leave = tMax_;
    for (std::size_t i = 0; i < 3; ++i) {
        const Real a = (box.min()[static_cast<int>(i)] - low_[i]) * inverse_[i];
        const Real b = (box.max()[static_cast<int>(i)] - high_[i]) * inverse_[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

unsigned PointBeamTree::BeamSlabs::meets(const Node& node) const {
    std::array<Real, width> enter;
    std::array<Real, width> leave;
    enter.fill(tMin_);
    leave.fill(tMax_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < width; ++i) {
            const Real a = (node.rows[axis][i] - low_[axis]) * inverse_[axis];
            const Real b = (node.rows[axis + 3][i] - high_[axis]) * inverse_[axis];
            const Real near = a < b ? a : b;
            const Real far = a < b ? b : a;
            enter[i] = near > enter[i] ? near : enter[i];
            leave[i] = far < leave[i] ? far : leave[i];
        }
    }
    unsigned met = 0;
    for (std::size_t i = 0; i < width; ++i) met |= enter[i] <= leave[i] ? 1U << i : 0U;
    return met;
}

}  // namespace caustic
