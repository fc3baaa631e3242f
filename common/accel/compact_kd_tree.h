#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "accel/kd_build.h"
#include "accel/tree_ray.h"

namespace caustic {

/// KD-tree in float with nodes of eight bytes, whose leaves are blocks of items that are tested at once.
///
/// Two children stand side by side, so a node needs one index, and the way down needs no branch that depends on the
/// ray's direction. All coordinates are in [-1, 1] (see TreeRay).
class CompactKdTree {
public:
    static constexpr std::uint32_t noItem = 0xffffffffU;  ///< in place of an item where a block has less than `block`

    /// @param boxes  one for each item
    /// @param rule   rule.block is the size of the blocks
    CompactKdTree(std::vector<KdBox<float>> boxes, const KdRule& rule, const KdClip<float>& clip);

    /// The items of all blocks, rule.block for each, which the tree itself has no use for: they are gone afterwards.
    std::vector<std::uint32_t> takeBlockItems() { return std::move(blockItems_); }

    /// Calls visit(block) for the blocks that the ray may meet, those of near cells first. `visit` shortens ray.tMax
    /// when it finds a hit, and returns whether to stop.
    /// @tparam nearFirst  as for WideBvh; here the order costs nothing, so it is kept in any case
    /// @param onNode  called for every node that is visited, leaves included
    template <bool nearFirst, typename Visit, typename OnNode>
    void traverse(TreeRay& ray, const Visit& visit, const OnNode& onNode) const;

    /// Bytes that the nodes take.
    std::size_t memory() const { return nodes_.size() * sizeof(Node); }
    /// Levels, inner nodes and leaves together.
    int depth() const { return depth_; }
    std::size_t nodeCount() const { return nodes_.size(); }

private:
    struct Node {
        float plane;         ///< of an inner node; a leaf's count of blocks, as bits
        std::uint32_t word;  ///< two bits of axis, 3 for a leaf; the rest is the lower child or the first block
    };
    struct Waiting {
        Node node;
        float tNear;
        float tFar;
    };
    static constexpr std::size_t stackSize = 48;  // one a level, one above: deepestKdTree(2³⁰) = 47

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> blockItems_;
    KdBox<float> box_;
    int depth_ = 0;
};

template <bool nearFirst, typename Visit, typename OnNode>
void CompactKdTree::traverse(TreeRay& ray, const Visit& visit, const OnNode& onNode) const {
    // A plane is crossed at plane · inverse - origin · inverse, give or take the slack: one fused operation for each
    // end.
    std::array<float, 3> earliestOf;
    std::array<float, 3> latestOf;
    std::array<std::uint64_t, 3> downwardsOf;
    float tExit = ray.tMax;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const float inverse = ray.inverse[axis];
        const float slack = treeRayPadding * std::abs(inverse);
        earliestOf[axis] = -ray.origin[axis] * inverse - slack;
        latestOf[axis] = -ray.origin[axis] * inverse + slack;
        downwardsOf[axis] = inverse < 0 ? ~std::uint64_t{0} : 0;
        // Not by the direction's sign: a branch would be guessed wrongly every other time.
        const float atLower = (box_.min()[axis] - ray.origin[axis]) * inverse;
        const float atUpper = (box_.max()[axis] - ray.origin[axis]) * inverse;
        tExit = std::min(tExit, std::max(atLower, atUpper) + slack);
    }

    std::array<Waiting, stackSize> stack;
    std::size_t waiting = 0;
    const Node* const nodes = nodes_.data();
    Waiting cell = {nodes[0], 0, tExit};
    while (true) {
        const Node node = cell.node;
        onNode();
        const std::uint32_t axis = node.word & 3;
        if (axis == 3) {
            const std::uint32_t first = node.word >> 2;
            const std::uint32_t end = first + std::bit_cast<std::uint32_t>(node.plane);
            for (std::uint32_t block = first; block < end; ++block) {
                if (visit(block)) return;
            }
            do {
                if (waiting == 0) return;
                cell = stack[--waiting];
            } while (cell.tNear > ray.tMax);
            continue;
        }
        const float inverse = ray.inverse[axis];
        const float latest = std::fma(node.plane, inverse, latestOf[axis]);
        const float earliest = std::fma(node.plane, inverse, earliestOf[axis]);
        // Both children are fetched before it is known which one is wanted: 6 % more rays. And whether one
        // waits takes no branch, which would be guessed wrongly too often: 5 %. What doesn't wait is written over.
        const Node* const children = nodes + (node.word >> 2);
        const auto lower = std::bit_cast<std::uint64_t>(children[0]);
        const auto upper = std::bit_cast<std::uint64_t>(children[1]);
        const std::uint64_t swap = (lower ^ upper) & downwardsOf[axis];
        const std::uint64_t nearer = lower ^ swap;
        const std::uint64_t farther = upper ^ swap;
        const bool farOnly = latest < cell.tNear;
        const bool nearOnly = earliest > cell.tFar;
        stack[waiting] = {std::bit_cast<Node>(farther), std::max(cell.tNear, earliest), cell.tFar};
        waiting += farOnly || nearOnly ? 0 : 1;
        cell.node = std::bit_cast<Node>(farOnly ? farther : nearer);
        cell.tFar = farOnly ? cell.tFar : std::min(cell.tFar, latest);
    }
}

}  // namespace caustic
