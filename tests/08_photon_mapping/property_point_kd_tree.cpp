#include <gtest/gtest.h>

#include <numeric>

#include "core/error.h"
#include "expect_brute_force.h"

namespace caustic::test {
namespace {

// The same k distances as brute force, ties aside, in clouds of every kind and of every size around that of a leaf.
TEST(PointKdTree, FindsWhatBruteForceFinds) {
    for (const std::size_t n : {1, 2, 7, 8, 9, 15, 16, 17, 24, 25, 33, 100, 127, 128, 129, 1000}) {
        for (const PointCloud& cloud : pointClouds(n, 1)) expectBruteForce(cloud, 60, 2);
        if (HasFatalFailure()) return;
    }
}

// Each point has a place of its own, and the tree knows where it is.
TEST(PointKdTree, KeepsEveryPointOnce) {
    for (const PointCloud& cloud : pointClouds(777, 3)) {
        const PointKdTree tree(cloud.points);
        std::vector<std::uint32_t> order(tree.order().begin(), tree.order().end());
        for (std::size_t place = 0; place < order.size(); ++place)
            ASSERT_EQ(tree.point(place), cloud.points[order[place]]) << cloud.name;
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> all(cloud.points.size());
        std::iota(all.begin(), all.end(), 0);
        ASSERT_EQ(order, all) << cloud.name;
    }
}

// Three floats, three doubles, a place and an eighth of a plane a point.
TEST(PointKdTree, TakesFortyBytesAPoint) {
    const PointKdTree tree(pointClouds(8000, 4)[0].points);
    EXPECT_LE(tree.memory(), 42U * 8000);
}

TEST(PointKdTree, OfNoPointsFindsNone) {
    const PointKdTree tree(std::span<const Vec3>{});
    NearestPoints found;
    tree.nearest(Vec3::Zero(), 3, 1, found);
    EXPECT_TRUE(found.points().empty());
    tree.within(Vec3::Zero(), 1, [](const NearPoint&) { ADD_FAILURE(); });
}

// Nothing is asked for: k = 0, a negative radius, a query that is no number.
TEST(PointKdTree, AnswersIdleQuestions) {
    const std::vector<Vec3> points(20, Vec3(1, 2, 3));
    const PointKdTree tree(points);
    NearestPoints found;
    tree.nearest(points[0], 0, 1, found);
    EXPECT_TRUE(found.points().empty());
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<Real>::quiet_NaN());
    tree.nearest(nowhere, 3, 1, found);
    EXPECT_TRUE(found.points().empty());
    tree.within(points[0], -1, [](const NearPoint&) { ADD_FAILURE(); });
    tree.within(points[0], std::numeric_limits<Real>::quiet_NaN(), [](const NearPoint&) { ADD_FAILURE(); });
    std::size_t count = 0;
    tree.within(points[0], 0, [&count](const NearPoint&) { ++count; });
    EXPECT_EQ(count, points.size());  // the border is included
}

// However far away the query is, and however large or small the cloud.
TEST(PointKdTree, AnswersFromAfar) {
    for (const Real size : {1e-140, 1e-30, 1e-6, 1e6, 1e40, 1e140}) {
        PointCloud cloud = pointClouds(200, 5)[0];
        for (Vec3& point : cloud.points) point *= size;
        const PointKdTree tree(cloud.points);
        NearestPoints found;
        for (const Real distance : {1e-3, 1.0, 1e4, 1e9}) {
            const Vec3 query = size * distance * Vec3(0.3, -0.5, 0.8);
            expectNearest(cloud, tree, query, 5, std::numeric_limits<Real>::infinity(), found);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(PointKdTree, RefusesWhatIsNoPoint) {
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(), 1e200}) {
        const std::vector<Vec3> points = {Vec3::Zero(), Vec3(0, bad, 0)};
        EXPECT_THROW(PointKdTree{points}, InputError);
    }
}

}  // namespace
}  // namespace caustic::test
