#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "accel/kd_tree.h"
#include "math/slabs.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// The tree is built by the median here, so that these tests need no other exercise.
KdTree treeOf(const std::vector<Bounds3>& boxes) {
    return KdTree(boxes, KdRule{.split = KdSplit::Median, .median = 2});
}

std::vector<Bounds3> randomBoxes(std::uint64_t seed, int count, Real size) {
    std::vector<Bounds3> boxes;
    for (int i = 0; i < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Vec3 corner = inCube(random);
        boxes.emplace_back(corner, corner + size * (inCube(random) + 1.1 * Vec3::Ones()));
    }
    return boxes;
}

struct Nearest {
    std::optional<std::uint32_t> item;
    Real t = 0;
    std::size_t tests = 0;
};

// Solid boxes as items: a ray's hit is where it enters.
std::optional<Real> entryOf(const Bounds3& box, const Ray& ray) {
    const Interval inside = slabInterval(box, ray);
    if (inside.empty() || !ray.reaches(inside.lower)) return std::nullopt;
    return inside.lower;
}

Nearest nearestByTree(const KdTree& tree, const std::vector<Bounds3>& boxes, const Ray& ray) {
    Nearest nearest;
    Ray shortened = ray;
    tree.traverse(shortened, [&](std::uint32_t item) {
        ++nearest.tests;
        const auto t = entryOf(boxes[item], shortened);
        if (!t) return false;
        nearest.item = item;
        nearest.t = *t;
        shortened.tMax = *t;
        return false;
    });
    return nearest;
}

Nearest nearestOfAll(const std::vector<Bounds3>& boxes, const Ray& ray) {
    Nearest nearest;
    Ray shortened = ray;
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
        const auto t = entryOf(boxes[item], shortened);
        if (!t) continue;
        nearest.item = item;
        nearest.t = *t;
        shortened.tMax = *t;
    }
    return nearest;
}

// A large item may be hit behind the cell that it was found in, and a nearer one stand in a later cell.
TEST(Traversal, FindsTheNearestOfAllItems) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::vector<Bounds3> boxes = randomBoxes(seed, 60, seed % 2 == 0 ? 0.05 : 0.4);
        const KdTree tree = treeOf(boxes);
        for (std::uint64_t i = 0; i < 500; ++i) {
            Random random(seed, {1, i});
            const Ray ray = {3 * inCube(random), inCube(random)};
            const Nearest expected = nearestOfAll(boxes, ray);
            const Nearest found = nearestByTree(tree, boxes, ray);
            ASSERT_EQ(found.item.has_value(), expected.item.has_value())
                << "Is the far child visited as well when the ray crosses the plane within the cell?";
            if (found.item) {
                ASSERT_EQ(found.t, expected.t)
                    << "May the search end before all cells in front of the hit were visited?";
            }
        }
    }
}

// Rays within planes of the tree, along and against the axes: zero direction components, origins in planes.
TEST(Traversal, LosesNothingInPlanesOfTheTree) {
    std::vector<Bounds3> boxes;
    for (int x = 0; x < 6; ++x) {
        for (int y = 0; y < 6; ++y) {
            for (int z = 0; z < 6; ++z) boxes.emplace_back(Vec3(x, y, z), Vec3(x + 1, y + 1, z + 1));
        }
    }
    const KdTree tree = treeOf(boxes);
    for (std::uint64_t i = 0; i < 3000; ++i) {
        Random random(7, {i});
        const int axis = static_cast<int>(random.below(3));
        Vec3 direction = Vec3::Zero();
        direction[axis] = random.below(2) == 0 ? 1 : -1;
        if (random.below(2) == 0) direction[(axis + 1) % 3] = -0.0;
        Vec3 origin(static_cast<Real>(random.below(7)), static_cast<Real>(random.below(7)),
                    static_cast<Real>(random.below(7)));
        origin -= 10 * direction;
        const Ray ray = {origin, direction};
        // Every box that the ray touches must be tested, unless one in front of it ends the ray; so let nothing end it.
        std::vector<bool> tested(boxes.size(), false);
        Ray whole = ray;
        tree.traverse(whole, [&](std::uint32_t item) {
            tested[item] = true;
            return false;
        });
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            if (slabInterval(boxes[k], ray).empty()) continue;
            ASSERT_TRUE(tested[k])
                << "A ray in a plane belongs to both sides: is slack added before a side is left out?";
        }
    }
}

// How a ray's way through a node's cell should be judged: surely met, surely not, or too close to tell.
enum class Meeting { No, Close, Yes };

struct Cells {
    std::vector<Bounds3> boxes;  // of the nodes
    std::vector<Meeting> meetings;

    Cells(const KdTree& tree, const Ray& ray, Real margin) : boxes(tree.nodes().nodes.size()) {
        const auto& nodes = tree.nodes().nodes;
        boxes[0] = tree.nodes().box;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!nodes[i].isLeaf()) {
                const auto axis = static_cast<int>(nodes[i].axis);
                boxes[nodes[i].first] = boxes[nodes[i].first + 1] = boxes[i];
                boxes[nodes[i].first].max()[axis] = nodes[i].plane;
                boxes[nodes[i].first + 1].min()[axis] = nodes[i].plane;
            }
            const Vec3 by = Vec3::Constant(margin);
            const Bounds3 smaller(boxes[i].min() + by, boxes[i].max() - by);
            const Bounds3 larger(boxes[i].min() - by, boxes[i].max() + by);
            const bool sure = !smaller.isEmpty() && !slabInterval(smaller, ray).empty();
            const bool possible = !slabInterval(larger, ray).empty();
            meetings.push_back(sure ? Meeting::Yes : possible ? Meeting::Close : Meeting::No);
        }
    }
};

// Children come after their parents. Most rays are aimed at an edge of some cell, and pass it by a hundred millionth.
TEST(Traversal, VisitsTheCellsThatTheRayPassesAndNoOthers) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Real scale = std::array<Real, 3>{1, 1e-6, 1e6}[seed % 3];
        std::vector<Bounds3> items = randomBoxes(seed, 80, 0.2);
        for (Bounds3& box : items) box = {scale * box.min(), scale * box.max()};
        const KdTree tree = treeOf(items);
        const auto& nodes = tree.nodes().nodes;
        const std::vector<Bounds3> boxes = Cells(tree, {Vec3::Zero(), Vec3::UnitX()}, 0).boxes;
        for (std::uint64_t i = 0; i < 400; ++i) {
            Random random(seed, {2, i});
            const Bounds3& some = boxes[random.below(boxes.size())];
            Vec3 aim = some.corner(static_cast<Bounds3::CornerType>(random.below(8))) + 1e-8 * scale * inCube(random);
            aim.x() = random.uniform(some.min().x(), some.max().x());
            Ray ray = {3 * scale * inCube(random), {}};
            ray.direction = (aim - ray.origin) * random.uniform(0.1, 2);
            if (i % 4 == 0) ray.tMax = random.uniform(0.2, 1) / (ray.direction.norm() / (aim - ray.origin).norm());
            const Cells cells(tree, ray, 1e-12 * scale);
            std::vector<bool> visited(nodes.size(), false);
            std::vector<Real> entries;
            Ray whole = ray;
            tree.traverse(
                whole, [](std::uint32_t) { return false; },
                [&](const KdNode<Real>& node) {
                    const auto index = static_cast<std::size_t>(&node - nodes.data());
                    ASSERT_LT(index, nodes.size()) << "Which cell comes off an empty stack?";
                    visited[index] = true;
                    if (node.isLeaf() && cells.meetings[index] == Meeting::Yes)
                        entries.push_back(slabInterval(cells.boxes[index], ray).lower);
                });
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                if (cells.meetings[k] == Meeting::Close) continue;
                ASSERT_EQ(visited[k], cells.meetings[k] == Meeting::Yes)
                    << "Ray " << i << (visited[k] ? " visits a cell beside its way." : " leaves a cell of its way out.")
                    << " Where does the ray enter and leave each child's cell, and is onNode called for each?";
            }
            for (std::size_t k = 1; k < entries.size(); ++k)
                ASSERT_GE(entries[k], entries[k - 1] * (1 - 1e-9)) << "Which of the cells that wait comes first?";
        }
    }
}

// A ray that ends half a slack before it crosses the root's plane, from the start or by what a test found, is within
// the slack of the plane: on both sides.
TEST(Traversal, IsOnBothSidesWithinTheSlack) {
    for (std::uint64_t i = 0; i < 400; ++i) {
        Random random(9, {i});
        const KdTree tree = treeOf(randomBoxes(i, 30, 0.1));
        const KdNode<Real>& root = tree.nodes().nodes[0];
        const Bounds3& box = tree.nodes().box;
        // Through the plane, somewhere in the box.
        Vec3 aim = box.min() + Vec3(random.uniform(), random.uniform(), random.uniform()).cwiseProduct(box.sizes());
        aim[static_cast<int>(root.axis)] = root.plane;
        Ray whole = {3 * inCube(random), {}};
        whole.direction = aim - whole.origin;
        const KdRay kdRay(whole, box);
        const Real end = kdRay.crossing(root.plane, root.axis) - kdRay.slack[root.axis] / 2;
        for (const bool fromTheStart : {true, false}) {
            Ray ray = whole;
            if (fromTheStart) ray.tMax = end;
            std::array<bool, 2> visited = {false, false};
            tree.traverse(
                ray,
                [&](std::uint32_t) {
                    ray.tMax = std::min(ray.tMax, end);
                    return false;
                },
                [&](const KdNode<Real>& node) {
                    for (std::uint32_t side = 0; side < 2; ++side)
                        visited[side] = visited[side] || &node == &tree.nodes().nodes[root.first + side];
                });
            ASSERT_TRUE(visited[0] && visited[1])
                << "Is the slack taken off a crossing before the far side is left out, and before it waits?";
        }
    }
}

// A long row of items, one in each leaf: the first is hit, so the tree need not look at the others.
TEST(Traversal, LooksAtNearCellsFirstAndStopsAtTheHit) {
    std::vector<Bounds3> boxes;
    for (int i = 0; i < 256; ++i) boxes.emplace_back(Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1));
    const KdTree tree(boxes, KdRule{.split = KdSplit::Median, .median = 1});
    for (const Real sign : {1.0, -1.0}) {
        const Ray ray = {Vec3(sign > 0 ? -1 : 257, 0.5, 0.5), Vec3(sign, 0, 0)};
        const Nearest found = nearestByTree(tree, boxes, ray);
        ASSERT_TRUE(found.item.has_value());
        EXPECT_EQ(*found.item, sign > 0 ? 0U : 255U);
        EXPECT_LE(found.tests, 12U) << "Is the side that the ray enters first visited first, and a cell left out that "
                                       "begins behind the best hit so far?";
    }
}

// Shadow rays need any hit: the search ends when the test says so.
TEST(Traversal, EndsWhenTheTestSaysSo) {
    const std::vector<Bounds3> boxes = randomBoxes(3, 200, 0.5);
    const KdTree tree = treeOf(boxes);
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(4, {i});
        Ray ray = {3 * inCube(random), inCube(random)};
        int tests = 0;
        tree.traverse(ray, [&](std::uint32_t) {
            ++tests;
            return true;
        });
        ASSERT_LE(tests, 1) << "What does a test's result `true` mean?";
    }
}

// A ray that ends before the first item, or starts behind the last one.
TEST(Traversal, KeepsToTheRaysEnds) {
    std::vector<Bounds3> boxes;
    for (int i = 0; i < 64; ++i) boxes.emplace_back(Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1));
    const KdTree tree = treeOf(boxes);
    const auto testsOf = [&](Real tMin, Real tMax) {
        Ray ray = {Vec3(-10, 0.5, 0.5), Vec3::UnitX(), tMin, tMax};
        int tests = 0;
        tree.traverse(ray, [&](std::uint32_t) {
            ++tests;
            return false;
        });
        return tests;
    };
    EXPECT_EQ(testsOf(0, 5), 0) << "The ray ends before the tree's box begins.";
    EXPECT_EQ(testsOf(100, 200), 0) << "The ray starts behind the tree's box.";
    // Wherever the root's plane is, one of these pieces crosses it.
    for (int x = 4; x < 60; ++x) {
        EXPECT_LE(testsOf(x + 9, x + 11), 8) << "Are cells visited that the piece between tMin and tMax never meets?";
    }
}

}  // namespace
}  // namespace caustic
