#include "shape/group.h"

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "math/slabs.h"

namespace caustic {

Group::Group(std::vector<std::shared_ptr<const Shape>> members) : members_(std::move(members)) {
    checkArgument(!members_.empty(), "group", "0 members", "needs at least one");
    for (const auto& member : members_) {
        checkArgument(member != nullptr, "group", "null", "needs members that exist");
        bounds_.extend(member->bounds());
        bounded_ = bounded_ && member->bounded();
    }
}

std::optional<Hit> Group::intersect(const Ray& ray) const {
    if (!mayMeet(bounds_, ray)) return std::nullopt;

    std::optional<Hit> nearest;
    Ray shortened = ray;
    for (const auto& member : members_) {
        const std::optional<Hit> hit = member->intersect(shortened);
        if (!hit) continue;
        nearest = hit;
        shortened.tMax = hit->t;
    }
    return nearest;
}

bool Group::occluded(const Ray& ray) const {
    if (!mayMeet(bounds_, ray)) return false;
    return std::any_of(members_.begin(), members_.end(), [&](const auto& member) { return member->occluded(ray); });
}

}  // namespace caustic
