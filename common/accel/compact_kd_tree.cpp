#include "accel/compact_kd_tree.h"

#include <utility>

namespace caustic {

CompactKdTree::CompactKdTree(std::vector<KdBox<float>> boxes, const KdRule& rule, const KdClip<float>& clip) {
    const KdNodes<float> built = buildKdTree<float>(std::move(boxes), rule, clip);
    box_ = built.box;
    depth_ = built.depth;
    nodes_.reserve(built.nodes.size());
    for (const KdNode<float>& node : built.nodes) {
        if (!node.isLeaf()) {
            nodes_.push_back({node.plane, node.axis | node.first << 2});
            continue;
        }
        const auto first = static_cast<std::uint32_t>(blockItems_.size() / rule.block);
        const std::uint32_t blocks = (node.count + rule.block - 1) / rule.block;
        const auto items = built.items.begin() + node.first;
        blockItems_.insert(blockItems_.end(), items, items + node.count);
        blockItems_.resize(std::size_t{first + blocks} * rule.block, noItem);
        nodes_.push_back({std::bit_cast<float>(blocks), 3 | first << 2});
    }
}

}  // namespace caustic
