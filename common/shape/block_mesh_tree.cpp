#include "shape/block_mesh_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "shape/triangle_clip.h"
#include "shape/watertight.h"

namespace caustic {

namespace {

Bounds3 boxAround(const MeshData& mesh, const std::vector<std::uint32_t>& triangles) {
    Bounds3 box;
    for (const std::uint32_t triangle : triangles) box.extend(mesh.bounds(triangle));
    return box;
}

// Measured on the bunny and the dragon: a block of eight costs about half a step.
constexpr KdRule wideRule = {KdSplit::SurfaceAreaHeuristic, 1, 0.3, 8, 0.2, 8};

void plant(const MeshData& mesh, const MeshSpace& space, const std::vector<std::uint32_t>& triangles,
           std::optional<CompactKdTree>& tree) {
    std::vector<KdBox<float>> boxes;
    boxes.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) {
        const Bounds3 box = mesh.bounds(triangle);
        boxes.emplace_back(space.toTree(box.min()).cast<float>(), space.toTree(box.max()).cast<float>());
    }
    // Cells are rounded to floats, corners are not: without a margin a triangle in a face of the box could be outside
    // of every cell. What is left of it then is flat.
    const Vec3 margin = Vec3::Constant(treeRayPadding / 8);
    const auto clip = [&](std::uint32_t item, const KdBox<float>& inside) {
        const auto [a, b, c] = mesh.corners(triangles[item]);
        const Bounds3 cell(inside.min().cast<Real>() - margin, inside.max().cast<Real>() + margin);
        const Bounds3 left = clippedTriangleBounds(space.toTree(a), space.toTree(b), space.toTree(c), cell);
        if (left.isEmpty()) return KdBox<float>();
        const auto inCell = [&](const Vec3& corner) {
            return corner.cast<float>().cwiseMax(inside.min()).cwiseMin(inside.max()).eval();
        };
        return KdBox<float>(inCell(left.min()), inCell(left.max()));
    };
    tree.emplace(std::move(boxes), wideRule, clip);
}

void plant(const MeshData& mesh, const MeshSpace& space, const std::vector<std::uint32_t>& triangles,
           std::optional<WideBvh>& tree) {
    std::vector<BuildBox> boxes;
    boxes.reserve(triangles.size());
    for (std::uint32_t item = 0; item < triangles.size(); ++item) {
        const Bounds3 box = mesh.bounds(triangles[item]);
        const Eigen::Vector3f lower = space.toTree(box.min()).cast<float>();
        const Eigen::Vector3f upper = space.toTree(box.max()).cast<float>();
        const BuildBox::Row low = {lower.x(), lower.y(), lower.z(), std::bit_cast<float>(item)};
        const BuildBox::Row high = {upper.x(), upper.y(), upper.z(), 0};
        boxes.push_back(BuildBox{low, high});
    }
    tree.emplace(std::move(boxes));
}

template <typename Tree>
Tree planted(const MeshData& mesh, const MeshSpace& space, const std::vector<std::uint32_t>& triangles) {
    std::optional<Tree> tree;
    plant(mesh, space, triangles, tree);
    return std::move(*tree);
}

// Triangles that wait for the test in `Real`, and what it found.
class Candidates {
public:
    Candidates(const MeshData& mesh, const Ray& ray) : mesh_(mesh), ray_(ray) {}

    bool full() const { return count_ == waiting_.size(); }

    void add(std::uint32_t triangle, float earliest) { waiting_[count_++] = {triangle, earliest}; }

    // Tests those that may still be the nearest, and forgets all. Returns how many it tested.
    template <typename OnHit>
    std::uint64_t confirm(const TreeRay& treeRay, const OnHit& onHit) {
        std::uint64_t tested = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if (waiting_[i].earliest > treeRay.tMax) continue;
            ++tested;
            if (test(waiting_[i].triangle)) onHit(nearest_->t);
        }
        count_ = 0;
        return tested;
    }

    const std::optional<MeshHit>& nearest() const { return nearest_; }

private:
    struct Waiting {
        std::uint32_t triangle;
        float earliest;
    };

    bool test(std::uint32_t triangle) {
        if (!sheared_) sheared_.emplace(ray_);
        const auto& [i, j, k] = mesh_.triangles[triangle];
        const auto found = intersectWatertight(*sheared_, mesh_.positions[i], mesh_.positions[j], mesh_.positions[k]);
        if (!found) return false;
        sheared_->ray.tMax = found->t;
        nearest_ = MeshHit{*found, triangle};
        return true;
    }

    const MeshData& mesh_;
    const Ray& ray_;
    std::optional<ShearedRay> sheared_;
    std::array<Waiting, 32> waiting_;
    std::size_t count_ = 0;
    std::optional<MeshHit> nearest_;
};

}  // namespace

template <typename Tree>
BlockMeshTree<Tree>::BlockMeshTree(std::shared_ptr<const MeshData> mesh)
    : mesh_(std::move(mesh)),
      space_(boxAround(*mesh_, trianglesWithArea(*mesh_))),
      triangles_(trianglesWithArea(*mesh_)),
      tree_(planted<Tree>(*mesh_, space_, triangles_)),
      blocks_(makeTriangleBlocks(*mesh_, space_, tree_.blockItems(), triangles_)) {}

template <typename Tree>
template <bool any, bool counted>
std::optional<MeshHit> BlockMeshTree<Tree>::search(const Ray& ray, MeshWork* work) const {
    if (MeshRay::comesFromTooFar(space_, ray)) return searchAll<any>(ray);
    std::optional<MeshRay> inTree = MeshRay::through(space_, ray);
    if (!inTree) return std::nullopt;
    TreeRay& treeRay = inTree->tree;
    const Ray8 ray8(treeRay);
    Candidates candidates(*mesh_, ray);
    const auto confirm = [&] {
        const std::uint64_t tested =
            candidates.confirm(treeRay, [&](Real t) { treeRay.tMax = std::min(treeRay.tMax, inTree->toTree(t)); });
        if (counted) work->confirmed += tested;
    };
    const auto visit = [&](std::uint32_t index) {
        const TriangleBlock& block = blocks_[index];
        const Nominees found = nominate(block, ray8, treeRay.tMax);
        if (counted) ++work->tests;
        if (found.lanes == 0) return false;
        if (!any) {
            for (unsigned sure = found.sure; sure != 0; sure &= sure - 1) {
                const auto lane = static_cast<unsigned>(std::countr_zero(sure));
                treeRay.tMax = std::min(treeRay.tMax, found.t[lane] + found.error[lane]);
            }
        }
        for (unsigned rest = any && found.sure != 0 ? found.sure : found.lanes; rest != 0; rest &= rest - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(rest));
            const float earliest = found.earliest(lane);
            if (earliest > treeRay.tMax) continue;
            candidates.add(block.triangle[lane], earliest);
            if (candidates.full()) confirm();
        }
        if (!any) return false;
        confirm();
        return candidates.nearest().has_value();
    };
    const auto onNode = [&] {
        if (counted) ++work->nodes;
    };
    tree_.traverse(treeRay, visit, onNode);
    confirm();
    return candidates.nearest();
}

template <typename Tree>
template <bool any>
std::optional<MeshHit> BlockMeshTree<Tree>::searchAll(const Ray& ray) const {
    Candidates candidates(*mesh_, ray);
    const TreeRay anyTime({}, {}, std::numeric_limits<float>::infinity());
    for (const std::uint32_t triangle : triangles_) {
        candidates.add(triangle, 0);
        if (candidates.full()) candidates.confirm(anyTime, [](Real) {});
        if (any && candidates.nearest()) return candidates.nearest();
    }
    candidates.confirm(anyTime, [](Real) {});
    return candidates.nearest();
}

template <typename Tree>
std::optional<MeshHit> BlockMeshTree<Tree>::intersect(const Ray& ray) const {
    return search<false, false>(ray, nullptr);
}

template <typename Tree>
bool BlockMeshTree<Tree>::occluded(const Ray& ray) const {
    return search<true, false>(ray, nullptr).has_value();
}

template <typename Tree>
std::optional<MeshHit> BlockMeshTree<Tree>::intersectCounted(const Ray& ray, MeshWork& work) const {
    return search<false, true>(ray, &work);
}

template <typename Tree>
MeshTreeSize BlockMeshTree<Tree>::size() const {
    const auto references = static_cast<std::size_t>(std::count_if(
        tree_.blockItems().begin(), tree_.blockItems().end(), [](std::uint32_t item) { return item != Tree::noItem; }));
    return {tree_.memory() + blocks_.size() * sizeof(TriangleBlock), tree_.nodeCount(), references, tree_.depth(), 0};
}

template class BlockMeshTree<CompactKdTree>;
template class BlockMeshTree<WideBvh>;

}  // namespace caustic
