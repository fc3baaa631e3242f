#include "shape/shape_tree.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace caustic {

namespace {

using Shapes = std::vector<std::shared_ptr<const Shape>>;

Shapes chosen(const Shapes& members, bool bounded) {
    Shapes found;
    for (const auto& member : members) {
        checkArgument(member != nullptr, "tree of shapes", "null", "needs members that exist");
        if (member->bounded() == bounded) found.push_back(member);
    }
    return found;
}

// A shape costs more than a triangle of a mesh: up to a whole tree of its own.
constexpr KdRule shapeRule = {.itemCost = 8};

KdTree plant(const Shapes& members) {
    std::vector<Bounds3> boxes;
    boxes.reserve(members.size());
    for (const auto& member : members) boxes.push_back(member->bounds());
    return KdTree(std::move(boxes), shapeRule);
}

}  // namespace

ShapeTree::ShapeTree(const Shapes& members)
    : unbounded_(chosen(members, false)), members_(chosen(members, true)), tree_(plant(members_)) {
    checkArgument(!members.empty(), "tree of shapes", "0 members", "needs at least one");
    for (const auto& member : members) bounds_.extend(member->bounds());
}

std::optional<Hit> ShapeTree::intersect(const Ray& ray) const {
    std::optional<Hit> nearest;
    Ray shortened = ray;
    const auto test = [&](const Shape& shape) {
        const std::optional<Hit> hit = shape.intersect(shortened);
        if (!hit) return;
        nearest = hit;
        shortened.tMax = hit->t;
    };
    for (const auto& shape : unbounded_) test(*shape);
    tree_.traverse(shortened, [&](std::uint32_t item) {
        test(*members_[item]);
        return false;
    });
    return nearest;
}

bool ShapeTree::occluded(const Ray& ray) const {
    const auto meets = [&](const auto& shape) { return shape->occluded(ray); };
    if (std::any_of(unbounded_.begin(), unbounded_.end(), meets)) return true;
    bool found = false;
    Ray whole = ray;
    tree_.traverse(whole, [&](std::uint32_t item) { return found = members_[item]->occluded(ray); });
    return found;
}

}  // namespace caustic
