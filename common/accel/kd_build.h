#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "math/real.h"

namespace caustic {

/// How the builder of a KD-tree places its planes.
enum class KdSplit {
    Median,                ///< through the middle of the box's longest side's events, until a leaf is small
    SurfaceAreaHeuristic,  ///< where a ray's expected cost is least
};

/// What the builder of a KD-tree weighs. Costs are in any unit; only their ratio counts.
struct KdRule {
    KdSplit split = KdSplit::SurfaceAreaHeuristic;
    Real stepCost = 1;         ///< of going from a node to its children
    Real itemCost = 2;         ///< of testing an item, or a block of them
    std::uint32_t block = 1;   ///< items that are tested at once: a leaf of n costs ⌈n / block⌉ items
    Real emptyBonus = 0.25;    ///< share of its cost that a split is forgiven when one side is empty
    std::uint32_t median = 8;  ///< Median stops at so many items
};

/// An axis-aligned box in the precision of a tree.
template <typename Scalar>
using KdBox = Eigen::AlignedBox<Scalar, 3>;

/// A box around the part of an item that is inside of another box; empty when no part is.
template <typename Scalar>
using KdClip = std::function<KdBox<Scalar>(std::uint32_t item, const KdBox<Scalar>& inside)>;

/// A node as it is built: a plane with two children side by side, or a leaf with a run of items.
template <typename Scalar>
struct KdNode {
    static constexpr std::uint32_t leaf = 3;

    Scalar plane = 0;           ///< of an inner node: where it cuts
    std::uint32_t axis = leaf;  ///< 0, 1, 2: the axis that the plane is perpendicular to; `leaf` for a leaf
    std::uint32_t first = 0;    ///< the lower child (the upper one follows it), or the leaf's first item
    std::uint32_t count = 0;    ///< of the leaf's items

    /// Whether it has items instead of children.
    bool isLeaf() const { return axis == leaf; }
};

/// A finished tree.
template <typename Scalar>
struct KdNodes {
    std::vector<KdNode<Scalar>> nodes;  ///< the root first
    std::vector<std::uint32_t> items;   ///< of all leaves; an item stands in each leaf that it reaches into
    KdBox<Scalar> box;                  ///< around all items
    int depth = 0;                      ///< nodes above the deepest leaf
    std::uint64_t work = 0;             ///< events that the builder looked at: what building costs, in a countable unit
};

/// The depth that no tree over n items exceeds: 8 + 1.3 log₂ n. Source: Pharr, Jakob, Humphreys 2016, section 4.4.1.
int deepestKdTree(std::size_t items);

/// Where an item's box begins or ends along an axis, or both: a place where the number of items to either side changes.
template <typename Scalar>
struct KdEvent {
    /// What happens there; in this order where several events stand at one place.
    enum Kind : std::uint32_t { End, Flat, Start };

    /// @param number  less than 2³⁰
    KdEvent(Scalar place, std::uint32_t number, Kind what) : at(place), word(number << 2 | what) {}

    /// The item whose box it is.
    std::uint32_t item() const { return word >> 2; }
    /// What happens there.
    Kind kind() const { return Kind{word & 3}; }

    Scalar at;           ///< the place along the axis
    std::uint32_t word;  ///< item and kind

    /// By place, then by kind: what ends comes before what starts.
    friend bool operator<(const KdEvent& a, const KdEvent& b) {
        return a.at < b.at || (a.at == b.at && a.kind() < b.kind());
    }
};

/// A plane that the builder may cut along.
template <typename Scalar>
struct KdPlane {
    Scalar at = 0;
    std::uint32_t axis = 0;
    bool flatBelow = true;  ///< whether items that lie in the plane go to the lower side; else to the upper one
    Real cost = 0;          ///< what a ray through the box is expected to cost
};

/// Expected cost of a ray through a box that is cut in two: a step, and each side's leafCost times the chance that a
/// ray which is in the box meets that side. By Crofton's formula that is the ratio of the surfaces' areas. When a
/// side has no item, a share of all of that is forgiven: emptyBonus. Source: MacDonald, Booth 1990, Heuristics for
/// Ray Tracing Using Space Subdivision.
/// @param axis,at      the plane, which cuts the box
/// @param below,above  how many items either side has
template <typename Scalar>
Real splitCost(const KdBox<Scalar>& box, std::uint32_t axis, Scalar at, std::uint32_t below, std::uint32_t above,
               const KdRule& rule);

/// Cost of testing all items of a leaf: of all its blocks, full or not. 0 for none.
Real leafCost(std::uint32_t items, const KdRule& rule);

/// The cheapest plane strictly within the box perpendicular to an axis, by one sweep over the events. An item is below
/// the plane when some of it is, above when some of it is, and both when it is cut; one that is flat and lies in the
/// plane counts on one side, whichever costs less.
/// @param events  of that axis, sorted; an item has a Start and an End, or is Flat
/// @param items   how many there are in the box
/// @param best    replaced when a plane of this axis costs less than it; stays when the best one costs as much
template <typename Scalar>
void sweepPlanes(std::span<const KdEvent<Scalar>> events, const KdBox<Scalar>& box, std::uint32_t axis,
                 std::uint32_t items, const KdRule& rule, KdPlane<Scalar>& best);

/// Builds a tree over boxes in O(n log n): the events of all three axes are sorted once; a split keeps their order,
/// and merges in those of the items that it cut.
/// Source: Wald, Havran 2006, On Building Fast kd-Trees for Ray Tracing, and on Doing That in O(N log N).
///
/// An item goes to each side that it reaches into; what is left of it there, `clip` says. The depth is bounded by
/// deepestKdTree, and the leaves together hold at most 24 references an item: beyond that nothing is split any more.
/// @param boxes  one for each item, finite; at most 2³⁰
/// @throws InputError when a box is empty or not finite
template <typename Scalar>
KdNodes<Scalar> buildKdTree(std::vector<KdBox<Scalar>> boxes, const KdRule& rule, const KdClip<Scalar>& clip);

}  // namespace caustic
