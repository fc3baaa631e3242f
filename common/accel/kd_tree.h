#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "accel/kd_build.h"
#include "core/not_implemented.h"
#include "math/bounds.h"
#include "math/ray.h"

namespace caustic {

/// What a KD-tree needs of a ray, computed once.
struct KdRay {
    /// @param box  of the tree
    KdRay(const Ray& ray, const Bounds3& box);

    /// When the ray crosses the plane.
    Real crossing(Real plane, std::uint32_t axis) const { return (plane - origin[axis]) * inverse[axis]; }

    Vec3 origin;   ///< the ray's
    Vec3 inverse;  ///< of the direction; where that is zero, of a tiny number, so that it is finite

    /// By how much a crossing may be off: rounding here, and in the test of an item that accepts a ray which misses it
    /// by rounding. Items within that of a plane are looked for on both sides, so none that the test accepts is lost.
    Vec3 slack;

    Real tNear;  ///< where the ray enters the tree's box
    Real tFar;   ///< where it leaves it; before tNear when the ray misses the box
};

/// KD-tree over anything that has a box: space is cut by planes, again and again, and a ray looks only at the items of
/// the cells that it passes through, the nearest cell first.
///
/// The tree knows its items by their numbers; whoever asks tests them. Trees may hold trees.
/// Source: Havran 2000, Heuristic Ray Shooting Algorithms. Tests: tests/04_kd_tree/property_mesh_trees.cpp.
class KdTree {
public:
    /// @param boxes  a finite one for each item; no boxes make a tree that no ray meets
    /// @param clip   what is left of an item in a cell; by default of its box
    explicit KdTree(std::vector<Bounds3> boxes, const KdRule& rule = {}, const KdClip<Real>& clip = {});

    /// Calls test(item) for items that the ray may meet between tMin and tMax, near cells first. `test` shortens
    /// ray.tMax when it finds a hit, which prunes the cells that begin behind it, and returns whether to stop at
    /// once. An item may be tested more than once. Crossings are rounded: a ray within KdRay::slack of a plane is on
    /// both sides.
    /// @param onNode  called for every node that is visited, leaves included
    template <typename Test, typename OnNode>
    void traverse(Ray& ray, const Test& test, const OnNode& onNode) const;

    /// The same, without looking at nodes.
    template <typename Test>
    void traverse(Ray& ray, const Test& test) const {
        traverse(ray, test, [](const KdNode<Real>&) {});
    }

    /// Nodes and items: to be drawn and counted.
    const KdNodes<Real>& nodes() const { return tree_; }

    /// Bytes that nodes and items take.
    std::size_t memory() const;

private:
    // A cell that waits for its turn.
    struct Waiting {
        std::uint32_t node;
        Real tNear;
        Real tFar;
    };
    // One cell may wait at each level; no tree is deeper than deepestKdTree(2³⁰) = 47.
    static constexpr std::size_t stackSize = 48;

    KdNodes<Real> tree_;
};

template <typename Test, typename OnNode>
void KdTree::traverse(Ray& ray, const Test& test, const OnNode& onNode) const {
    //! [ex-04.3]
    const KdRay kdRay(ray, tree_.box);
    if (!(kdRay.tNear <= kdRay.tFar)) return;

    std::array<Waiting, stackSize> stack;
    std::size_t waiting = 0;
    Waiting cell = {0, kdRay.tNear, kdRay.tFar};
    while (true) {
        const KdNode<Real>& node = tree_.nodes[cell.node];
        onNode(node);
        if (node.isLeaf()) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                if (test(tree_.items[i])) return;
            }
            // The nearest cell that waits, unless the ray ends before it.
            do {
                if (waiting == 0) return;
                cell = stack[--waiting];
            } while (cell.tNear > ray.tMax);
            continue;
        }
        const Real crossing = kdRay.crossing(node.plane, node.axis);
        const Real slack = kdRay.slack[node.axis];
        const bool upwards = kdRay.inverse[node.axis] > 0;
        const std::uint32_t nearer = upwards ? node.first : node.first + 1;
        const std::uint32_t farther = upwards ? node.first + 1 : node.first;
        if (crossing + slack < cell.tNear) {
            cell.node = farther;
        } else if (crossing - slack > cell.tFar) {
            cell.node = nearer;
        } else {
            stack[waiting++] = {farther, std::max(cell.tNear, crossing - slack), cell.tFar};
            cell = {nearer, cell.tNear, std::min(cell.tFar, crossing + slack)};
        }
    }
    //! [ex-04.3]
}

}  // namespace caustic
