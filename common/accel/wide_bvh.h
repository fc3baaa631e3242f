#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "accel/float8.h"
#include "accel/tree_ray.h"

namespace caustic {

/// Axis-aligned box in float, as the builder sorts it: a corner is one vector. The fourth lane of `lower` carries the
/// number of the item that is inside, the fourth of `upper` is zero.
struct BuildBox {
    using Row = float __attribute__((vector_size(16)));
    Row lower;
    Row upper;
};

/// Bounding volume hierarchy with eight children a node, tested at once: the modern rival of the KD-tree. It sorts
/// items instead of cutting space, so each item is in one leaf; in return the boxes of neighbours overlap.
///
/// Built as a binary tree first, by the surface area heuristic over 16 to 128 bins (Wald 2007), down to leaves of one
/// block of at most eight items. Then those of its branches become the children of wide nodes for which all nodes
/// together have the least surface: a ray meets a node the more often the larger it is (Ylitie, Karras, Laine 2017,
/// Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs). All coordinates are in [-1, 1] (see
/// TreeRay).
class WideBvh {
public:
    static constexpr std::uint32_t width = 8;             ///< children of a node, items of a block
    static constexpr std::uint32_t noItem = 0xffffffffU;  ///< in place of an item where a block has less than eight

    /// @param boxes  one for each item; at least one
    explicit WideBvh(std::vector<BuildBox> boxes);

    /// The items of all blocks, eight for each, which the tree itself has no use for: they are gone afterwards.
    std::vector<std::uint32_t> takeBlockItems() { return std::move(blockItems_); }

    /// Calls visit(block) for the blocks that the ray may meet. `visit` shortens ray.tMax when it finds a hit, and
    /// returns whether to stop.
    /// @tparam nearFirst  whether near blocks come before far ones; a search for any hit is faster without
    /// @param onNode  called for every node that is visited, blocks not included
    template <bool nearFirst, typename Visit, typename OnNode>
    void traverse(TreeRay& ray, const Visit& visit, const OnNode& onNode) const;

    /// Bytes that the nodes take.
    std::size_t memory() const { return nodes_.size() * sizeof(Node); }
    /// Levels, and nodes that aren't blocks.
    int depth() const { return depth_; }
    std::size_t nodeCount() const { return nodes_.size(); }

private:
    friend class WideBvhBuilder;

    struct alignas(64) Node {
        Float8 rows[6];              // lower x y z, upper x y z of the children
        std::uint32_t child[width];  // a node, or leafBit and a block
    };
    struct Waiting {
        std::uint32_t child;
        float t;
    };

    // Where a ray enters and leaves the boxes of a node's children.
    class Slabs {
    public:
        explicit Slabs(const TreeRay& ray);
        Float8 enter(const Node& node) const;
        Float8 leave(const Node& node, float tMax) const;

    private:
        Float8 inverse_[3];
        Float8 origin_[3];  // times inverse_
        unsigned near_[3];  // the rows by which the ray enters a box
        unsigned far_[3];   // and those by which it leaves
    };

    // Insertion keeps the farthest lowest; few children are hit, so it beats a sort.
    static void insert(const Waiting* base, Waiting* slot, const Waiting& other) {
        while (slot > base && slot[-1].t < other.t) {
            *slot = slot[-1];
            --slot;
        }
        *slot = other;
    }

    static constexpr std::uint32_t leafBit = 0x80000000U;
    // Seven may wait at each level. The builder halves below level 64, which ends 27 levels later: 2³⁰ items in eights.
    static constexpr int largestDepth = 92;
    static constexpr int stackSize = 7 * largestDepth + 1;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> blockItems_;
    int depth_ = 0;
};

inline WideBvh::Slabs::Slabs(const TreeRay& ray) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        inverse_[axis] = broadcast8(ray.inverse[axis]);
        origin_[axis] = broadcast8(ray.origin[axis] * ray.inverse[axis]);
        near_[axis] = ray.inverse[axis] < 0 ? axis + 3 : axis;
        far_[axis] = 3 + 2 * axis - near_[axis];
    }
}

inline Float8 WideBvh::Slabs::enter(const Node& node) const {
    return max8(
        max8(fms8(node.rows[near_[0]], inverse_[0], origin_[0]), fms8(node.rows[near_[1]], inverse_[1], origin_[1])),
        max8(fms8(node.rows[near_[2]], inverse_[2], origin_[2]), Float8{}));
}

inline Float8 WideBvh::Slabs::leave(const Node& node, float tMax) const {
    return min8(
        min8(fms8(node.rows[far_[0]], inverse_[0], origin_[0]), fms8(node.rows[far_[1]], inverse_[1], origin_[1])),
        min8(fms8(node.rows[far_[2]], inverse_[2], origin_[2]), broadcast8(tMax)));
}

template <bool nearFirst, typename Visit, typename OnNode>
void WideBvh::traverse(TreeRay& ray, const Visit& visit, const OnNode& onNode) const {
    const Slabs slabs(ray);
    const Node* const nodes = nodes_.data();
    std::array<Waiting, stackSize> stack;
    Waiting* top = stack.data();
    std::uint32_t current = 0;
    while (true) {
        if ((current & leafBit) != 0) {
            if (visit(current & ~leafBit)) return;
        } else {
            const Node& node = nodes[current];
            onNode();
            const Float8 enter = slabs.enter(node);
            unsigned hits = lanesOf(enter <= slabs.leave(node, ray.tMax));
            if (hits != 0) {
                unsigned lane = static_cast<unsigned>(std::countr_zero(hits));
                hits &= hits - 1;
                current = node.child[lane];
                if (hits == 0) continue;
                if constexpr (!nearFirst) {
                    for (; hits != 0; hits &= hits - 1) {
                        (top++)->child = node.child[std::countr_zero(hits)];
                    }
                    continue;
                }
                const auto times = std::bit_cast<std::array<float, width>>(enter);
                float nearest = times[lane];
                Waiting* const base = top;
                do {
                    lane = static_cast<unsigned>(std::countr_zero(hits));
                    hits &= hits - 1;
                    Waiting other = {node.child[lane], times[lane]};
                    if (other.t < nearest) {
                        std::swap(other.child, current);
                        std::swap(other.t, nearest);
                    }
                    insert(base, top++, other);
                } while (hits != 0);
                continue;
            }
        }
        do {
            if (top == stack.data()) return;
            --top;
        } while (nearFirst && top->t > ray.tMax);
        current = top->child;
    }
}

}  // namespace caustic
