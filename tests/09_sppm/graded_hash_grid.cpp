#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "accel/hash_grid.h"
#include "core/random.h"

namespace caustic {
namespace {

using Places = std::vector<std::uint32_t>;

std::vector<Vec3> cloud(std::size_t count, const Vec3& low, const Vec3& high, std::uint64_t seed) {
    Random random(seed, {count});
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()),
                          random.uniform(low.z(), high.z())});
    return points;
}

Places bruteForce(const std::vector<Vec3>& points, const Vec3& query, Real radius) {
    Places found;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if ((points[i] - query).squaredNorm() <= radius * radius) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

// In the order of the list; a point that is visited twice stands there twice.
Places visited(const HashGrid& grid, const Vec3& query, Real radius) {
    Places found;
    grid.within(query, radius, [&](const NearPoint& near) {
        EXPECT_NEAR(near.squaredDistance, (grid.point(near.place) - query).squaredNorm(), 1e-12)
            << "Is it the squared distance?";
        found.push_back(grid.order()[near.place]);
    });
    std::sort(found.begin(), found.end());
    return found;
}

Places unique(Places places) {
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

// A cloud off the origin, radii from a tenth of a cube's edge to three of them, around places well inside the cloud.
TEST(HashGrid, FindsThePointsWithinARadius) {
    const Vec3 low(-7, 3, 100);
    const std::vector<Vec3> points = cloud(4000, low, low + Vec3(2, 1, 0.5), 1);
    const HashGrid grid(points, 0.1);
    Random random(2, {2});
    for (int trial = 0; trial < 400; ++trial) {
        const Vec3 query = cloud(1, low + Vec3(0.1, 0.1, 0.1), low + Vec3(1.9, 0.9, 0.4),
                                 50U + static_cast<unsigned>(trial))[0];
        const Real radius = 0.01 * std::pow(30, random.uniform(0, 1));
        ASSERT_EQ(unique(visited(grid, query, radius)), bruteForce(points, query, radius))
            << "radius " << radius << ": Which cubes does the ball reach into? Is the border inside?";
    }
}

// So few points that the table has a handful of slots, and so many cubes asked for that most share one.
TEST(HashGrid, VisitsEachPointOnce) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const std::vector<Vec3> points = cloud(6, -Vec3::Ones(), Vec3::Ones(), seed);
        const HashGrid grid(points, 0.5);
        for (const Real radius : {0.2, 0.35, 0.5}) {
            for (const Vec3& query : points) {
                const Places found = visited(grid, query, radius);
                ASSERT_FALSE(found.empty()) << "The point itself?";
                ASSERT_EQ(unique(found), found) << "Two cubes may have the same slot. Whose points are in its list?";
            }
        }
    }
}

// Photons on a wall; asked for from just outside their box, on every side, and from far away.
TEST(HashGrid, AsksFromOutsideToo) {
    const std::vector<Vec3> wall = cloud(3000, {-1, 0, -1}, {1, 0, 1}, 3);
    const HashGrid grid(wall, 0.2);
    const Real out = 1.04;
    std::size_t found = 0;
    for (int i = -20; i <= 20; ++i) {
        for (const Vec3& query : {Vec3(out, 0.03, 0.05 * i), Vec3(-out, 0, 0.05 * i), Vec3(0.05 * i, -0.05, out),
                                  Vec3(0.05 * i, 0.05, -out), Vec3(0.05 * i, 0.09, 0.3)}) {
            const Places expected = bruteForce(wall, query, 0.1);
            found += expected.size();
            ASSERT_EQ(visited(grid, query, 0.1), expected)
                << "from (" << query.transpose() << "): What of cubes with negative numbers, and of those without "
                << "points?";
        }
    }
    ASSERT_GT(found, 500U);
    EXPECT_TRUE(visited(grid, {50, 60, 70}, 0.1).empty());
}

}  // namespace
}  // namespace caustic
