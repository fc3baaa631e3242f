#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "accel/point_kd_tree.h"
#include "point_clouds.h"

namespace caustic::test {

/// Of all points: their squared distances.
inline std::vector<Real> squaredDistances(const PointCloud& cloud, const Vec3& query) {
    std::vector<Real> squared;
    squared.reserve(cloud.points.size());
    for (const Vec3& point : cloud.points) squared.push_back((point - query).squaredNorm());
    return squared;
}

/// What the search found must be the k smallest distances, bit for bit, each of a point of its own. Which of several
/// points at the same distance is found is the tree's choice.
inline void expectNearest(const PointCloud& cloud, const PointKdTree& tree, const Vec3& query, std::size_t k,
                          Real radius, NearestPoints& found) {
    tree.nearest(query, k, radius, found);
    std::vector<Real> expected;
    for (const Real one : squaredDistances(cloud, query)) {
        if (one <= radius * radius) expected.push_back(one);
    }
    const std::size_t count = std::min(k, expected.size());
    std::partial_sort(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count), expected.end());
    expected.resize(count);
    std::vector<Real> distances;
    std::set<std::uint32_t> places;
    for (const NearPoint& one : found.points()) {
        distances.push_back(one.squaredDistance);
        places.insert(one.place);
        ASSERT_EQ((tree.point(one.place) - query).squaredNorm(), one.squaredDistance) << cloud.name;
    }
    std::sort(distances.begin(), distances.end());
    ASSERT_EQ(distances, expected) << cloud.name << ", " << cloud.points.size() << " points, k = " << k;
    ASSERT_EQ(places.size(), count) << cloud.name << ": a point was found twice";
}

/// And all points within the radius, each once.
inline void expectWithin(const PointCloud& cloud, const PointKdTree& tree, const Vec3& query, Real radius) {
    std::vector<std::uint32_t> found;
    tree.within(query, radius, [&](const NearPoint& one) { found.push_back(tree.order()[one.place]); });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> expected;
    const std::vector<Real> squared = squaredDistances(cloud, query);
    for (std::size_t i = 0; i < squared.size(); ++i) {
        if (squared[i] <= radius * radius) expected.push_back(static_cast<std::uint32_t>(i));
    }
    ASSERT_EQ(found, expected) << cloud.name << ", " << cloud.points.size() << " points, radius " << radius;
}

/// Random queries of one cloud.
inline void expectBruteForce(const PointCloud& cloud, int queries, std::uint64_t seed) {
    const PointKdTree tree(cloud.points);
    ASSERT_EQ(tree.size(), cloud.points.size());
    NearestPoints found;
    Random random(seed, {cloud.points.size()});
    for (int i = 0; i < queries; ++i) {
        const Vec3 query = cloud.query(random);
        const Real radius = random.below(2) == 0 ? std::numeric_limits<Real>::infinity()
                                                 : cloud.size * std::pow(10, random.uniform(-4, 1));
        expectNearest(cloud, tree, query, 1 + random.below(60), radius, found);
        if (::testing::Test::HasFatalFailure()) return;
        if (i % 8 == 0) expectWithin(cloud, tree, query, cloud.size * std::pow(10, random.uniform(-4, 0.5)));
        if (::testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace caustic::test
