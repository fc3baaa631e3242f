#include "accel/kd_build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

constexpr std::size_t mostItems = std::size_t{1} << 30;
constexpr std::uint64_t mostReferencesPerItem = 24;

template <typename Scalar>
Real halfArea(const KdBox<Scalar>& box) {
    const Eigen::Matrix<Real, 3, 1> d = box.diagonal().template cast<Real>();
    return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

template <typename Scalar>
class KdBuilder {
public:
    KdBuilder(std::vector<KdBox<Scalar>> boxes, const KdRule& rule, const KdClip<Scalar>& clip)
        : boxes_(std::move(boxes)),
          rule_(rule),
          clip_(clip),
          deepest_(deepestKdTree(boxes_.size())),
          budget_(mostReferencesPerItem * boxes_.size()) {}

    KdNodes<Scalar> build() {
        Part all;
        all.items = static_cast<std::uint32_t>(boxes_.size());
        for (std::uint32_t item = 0; item < all.items; ++item) {
            all.box.extend(boxes_[item]);
            addEvents(all.events, item, boxes_[item]);
        }
        for (auto& events : all.events) std::sort(events.begin(), events.end());
        sides_.resize(boxes_.size());
        references_ = boxes_.size();
        tree_.box = all.box;
        tree_.nodes.emplace_back();
        buildNode(0, std::move(all), 0);
        return std::move(tree_);
    }

private:
    using Event = KdEvent<Scalar>;
    using Events = std::array<std::vector<Event>, 3>;

    enum class Side : std::uint8_t { Both, Below, Above };

    // The items of a node.
    struct Part {
        KdBox<Scalar> box;
        std::uint32_t items = 0;
        Events events;
    };

    static void addEvents(Events& events, std::uint32_t item, const KdBox<Scalar>& box) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            const Scalar low = box.min()[axis];
            const Scalar high = box.max()[axis];
            if (low == high) {
                events[axis].push_back({low, item, Event::Flat});
            } else {
                events[axis].push_back({low, item, Event::Start});
                events[axis].push_back({high, item, Event::End});
            }
        }
    }

    // Depth first; the depth is bounded, so the recursion is too.
    void buildNode(std::uint32_t index, Part part, int depth) {
        for (const auto& events : part.events) tree_.work += events.size();
        tree_.depth = std::max(tree_.depth, depth);
        KdPlane<Scalar> plane;
        if (depth >= deepest_ || !choosePlane(part, plane)) return makeLeaf(index, part);

        Part below;
        Part above;
        below.box = part.box;
        above.box = part.box;
        below.box.max()[plane.axis] = plane.at;
        above.box.min()[plane.axis] = plane.at;
        split(part, plane, below, above);
        if (references_ - part.items + below.items + above.items > budget_) return makeLeaf(index, part);

        references_ += below.items + above.items;
        references_ -= part.items;
        part.events = {};
        const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[index] = {plane.at, plane.axis, child, 0};
        tree_.nodes.resize(tree_.nodes.size() + 2);
        buildNode(child, std::move(below), depth + 1);
        buildNode(child + 1, std::move(above), depth + 1);
    }

    void makeLeaf(std::uint32_t index, const Part& part) {
        tree_.nodes[index] = {0, KdNode<Scalar>::leaf, static_cast<std::uint32_t>(tree_.items.size()), part.items};
        for (const Event& event : part.events[0]) {
            if (event.kind() != Event::End) tree_.items.push_back(event.item());
        }
    }

    // Whether to split at all, and where.
    bool choosePlane(const Part& part, KdPlane<Scalar>& plane) const {
        if (rule_.split == KdSplit::Median) return medianPlane(part, plane);
        plane.cost = leafCost(part.items, rule_);
        const Real limit = plane.cost;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            sweepPlanes<Scalar>(part.events[axis], part.box, axis, part.items, rule_, plane);
        }
        return plane.cost < limit;
    }

    bool medianPlane(const Part& part, KdPlane<Scalar>& plane) const {
        if (part.items <= rule_.median) return false;
        int axis = 0;
        part.box.diagonal().maxCoeff(&axis);
        plane.axis = static_cast<std::uint32_t>(axis);
        const auto& events = part.events[plane.axis];
        plane.at = events[events.size() / 2].at;
        return plane.at > part.box.min()[axis] && plane.at < part.box.max()[axis];
    }

    // Marks each item's side. All start as Both; one event is enough to know better.
    void classify(const Part& part, const KdPlane<Scalar>& plane) {
        const auto& events = part.events[plane.axis];
        for (const Event& event : events) sides_[event.item()] = Side::Both;
        for (const Event& event : events) {
            if (event.kind() == Event::Flat) {
                const bool below = event.at < plane.at || (event.at == plane.at && plane.flatBelow);
                sides_[event.item()] = below ? Side::Below : Side::Above;
            } else if (event.kind() == Event::End && event.at <= plane.at) {
                sides_[event.item()] = Side::Below;
            } else if (event.kind() == Event::Start && event.at >= plane.at) {
                sides_[event.item()] = Side::Above;
            }
        }
    }

    void split(const Part& part, const KdPlane<Scalar>& plane, Part& below, Part& above) {
        classify(part, plane);
        Events newBelow;
        Events newAbove;
        for (const Event& event : part.events[plane.axis]) {
            if (event.kind() == Event::End) continue;
            const Side side = sides_[event.item()];
            if (side == Side::Below) ++below.items;
            if (side == Side::Above) ++above.items;
            if (side != Side::Both) continue;
            addPart(event.item(), below, newBelow);
            addPart(event.item(), above, newAbove);
        }
        for (unsigned axis = 0; axis < 3; ++axis) {
            below.events[axis].reserve(2 * below.items);
            above.events[axis].reserve(2 * above.items);
            for (const Event& event : part.events[axis]) {
                const Side side = sides_[event.item()];
                if (side == Side::Below) below.events[axis].push_back(event);
                if (side == Side::Above) above.events[axis].push_back(event);
            }
            mergeIn(below.events[axis], newBelow[axis]);
            mergeIn(above.events[axis], newAbove[axis]);
        }
    }

    // What is left of an item that the plane cuts, on one of its sides.
    void addPart(std::uint32_t item, Part& side, Events& events) {
        const KdBox<Scalar> left = clip_ ? clip_(item, side.box) : boxes_[item].intersection(side.box);
        if (left.isEmpty()) return;
        ++side.items;
        addEvents(events, item, left);
    }

    static void mergeIn(std::vector<Event>& events, std::vector<Event>& further) {
        std::sort(further.begin(), further.end());
        const auto middle = static_cast<std::ptrdiff_t>(events.size());
        events.insert(events.end(), further.begin(), further.end());
        std::inplace_merge(events.begin(), events.begin() + middle, events.end());
    }

    std::vector<KdBox<Scalar>> boxes_;
    const KdRule& rule_;
    const KdClip<Scalar>& clip_;
    int deepest_;
    std::uint64_t budget_;
    std::uint64_t references_ = 0;
    std::vector<Side> sides_;
    KdNodes<Scalar> tree_;
};

}  // namespace

int deepestKdTree(std::size_t items) {
    return static_cast<int>(8 + 1.3 * std::log2(static_cast<Real>(std::max<std::size_t>(items, 1))));
}

Real leafCost(std::uint32_t items, const KdRule& rule) {
    return rule.itemCost * static_cast<Real>((items + rule.block - 1) / rule.block);
}

template <typename Scalar>
Real splitCost(const KdBox<Scalar>& box, std::uint32_t axis, Scalar at, std::uint32_t below, std::uint32_t above,
               const KdRule& rule) {
    //! [ex-04.1]
    KdBox<Scalar> lower = box;
    KdBox<Scalar> upper = box;
    lower.max()[axis] = at;
    upper.min()[axis] = at;
    const Real items =
        (halfArea(lower) * leafCost(below, rule) + halfArea(upper) * leafCost(above, rule)) / halfArea(box);
    const Real bonus = below == 0 || above == 0 ? 1 - rule.emptyBonus : 1;
    return bonus * (rule.stepCost + items);
    //! [ex-04.1]
}

template <typename Scalar>
void sweepPlanes(std::span<const KdEvent<Scalar>> events, const KdBox<Scalar>& box, std::uint32_t axis,
                 std::uint32_t items, const KdRule& rule, KdPlane<Scalar>& best) {
    //! [ex-04.2]
    using Event = KdEvent<Scalar>;
    std::uint32_t below = 0;
    std::uint32_t above = items;
    for (std::size_t i = 0; i < events.size();) {
        const Scalar at = events[i].at;
        std::array<std::uint32_t, 3> here = {0, 0, 0};
        for (; i < events.size() && events[i].at == at; ++i) ++here[events[i].kind()];

        above -= here[Event::End] + here[Event::Flat];
        if (at > box.min()[axis] && at < box.max()[axis]) {
            const std::uint32_t flat = here[Event::Flat];
            const Real flatBelow = splitCost(box, axis, at, below + flat, above, rule);
            const Real flatAbove = flat == 0 ? flatBelow : splitCost(box, axis, at, below, above + flat, rule);
            const Real cost = std::min(flatBelow, flatAbove);
            if (cost < best.cost) best = {at, axis, flatBelow <= flatAbove, cost};
        }
        below += here[Event::Start] + here[Event::Flat];
    }
    //! [ex-04.2]
}

template <typename Scalar>
KdNodes<Scalar> buildKdTree(std::vector<KdBox<Scalar>> boxes, const KdRule& rule, const KdClip<Scalar>& clip) {
    checkArgument(boxes.size() <= mostItems, "tree", std::to_string(boxes.size()) + " items", "must be at most 2^30");
    for (const KdBox<Scalar>& box : boxes) {
        const bool finite = box.min().allFinite() && box.max().allFinite();
        checkArgument(finite && !box.isEmpty(), "tree", "", "needs boxes that are finite and not empty");
    }
    return KdBuilder<Scalar>(std::move(boxes), rule, clip).build();
}

template Real splitCost(const KdBox<float>&, std::uint32_t, float, std::uint32_t, std::uint32_t, const KdRule&);
template Real splitCost(const KdBox<double>&, std::uint32_t, double, std::uint32_t, std::uint32_t, const KdRule&);
template void sweepPlanes(std::span<const KdEvent<float>>, const KdBox<float>&, std::uint32_t, std::uint32_t,
                          const KdRule&, KdPlane<float>&);
template void sweepPlanes(std::span<const KdEvent<double>>, const KdBox<double>&, std::uint32_t, std::uint32_t,
                          const KdRule&, KdPlane<double>&);
template KdNodes<float> buildKdTree(std::vector<KdBox<float>>, const KdRule&, const KdClip<float>&);
template KdNodes<double> buildKdTree(std::vector<KdBox<double>>, const KdRule&, const KdClip<double>&);

}  // namespace caustic
