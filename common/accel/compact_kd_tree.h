#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
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

    /// The items of all blocks, rule.block for each.
    const std::vector<std::uint32_t>& blockItems() const { return blockItems_; }

    /// Calls visit(block) for the blocks that the ray may meet, those of near cells first. `visit` shortens ray.tMax
    /// when it finds a hit, and returns whether to stop.
    /// @tparam nearFirst  as for WideBvh; here the order costs nothing, so it is kept in any case
    /// @param onNode  called for every node that is visited, leaves included
    template <bool nearFirst, typename Visit, typename OnNode>
    void traverse(TreeRay& ray, const Visit& visit, const OnNode& onNode) const;

    /// Bytes that the nodes take.
    std::size_t memory() const { return nodes_.size() * sizeof(Node); }
    /// Levels, inner nodes and leaves together, references to items.
    int depth() const { return depth_; }
    std::size_t nodeCount() const { return nodes_.size(); }
    std::size_t references() const { return references_; }

private:
    struct Node {
        float plane;         ///< of an inner node; a leaf's count of blocks, as bits
        std::uint32_t word;  ///< two bits of axis, 3 for a leaf; the rest is the lower child or the first block
    };
    struct Waiting {
        std::uint32_t node;
        float tNear;
        float tFar;
    };
    static constexpr std::size_t stackSize = 48;  // one a level, one above: deepestKdTree(2³⁰) = 47

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> blockItems_;
    KdBox<float> box_;
    std::size_t references_ = 0;
    int depth_ = 0;
};

template <bool nearFirst, typename Visit, typename OnNode>
void CompactKdTree::traverse(TreeRay& ray, const Visit& visit, const OnNode& onNode) const {
    std::array<float, 4> slack{};
    float tExit = ray.tMax;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const bool upwards = ray.inverse[axis] > 0;
        const float face = upwards ? box_.max()[axis] : box_.min()[axis];
        slack[axis] = treeRayPadding * std::abs(ray.inverse[axis]);
        tExit = std::min(tExit, (face - ray.origin[axis]) * ray.inverse[axis] + slack[axis]);
    }

    std::array<Waiting, stackSize> stack;
    std::size_t waiting = 0;
    Waiting cell = {0, 0, tExit};
    const Node* const nodes = nodes_.data();
    while (true) {
        const Node node = nodes[cell.node];
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
        const float crossing = (node.plane - ray.origin[axis]) * ray.inverse[axis];
        const std::uint32_t lower = node.word >> 2;
        const std::uint32_t downwards = ray.inverse[axis] < 0 ? 1 : 0;
        const float latest = crossing + slack[axis];
        const float earliest = crossing - slack[axis];
        // Without a branch, which is guessed wrongly too often: 5 % more rays. What doesn't wait is written over.
        const bool farOnly = latest < cell.tNear;
        const bool nearOnly = earliest > cell.tFar;
        stack[waiting] = {lower + 1 - downwards, std::max(cell.tNear, earliest), cell.tFar};
        waiting += farOnly || nearOnly ? 0 : 1;
        cell.node = lower + (farOnly ? 1 - downwards : downwards);
        cell.tFar = farOnly ? cell.tFar : std::min(cell.tFar, latest);
    }
}

}  // namespace caustic
