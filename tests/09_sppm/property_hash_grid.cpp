#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "accel/hash_grid.h"
#include "core/error.h"
#include "core/random.h"

namespace caustic {
namespace {

std::vector<Vec3> cloud(std::size_t count, Real size, const Vec3& center, std::uint64_t seed) {
    Random random(seed, {count});
    std::vector<Vec3> points;
    const auto one = [&] { return random.uniform(-size, size); };
    for (std::size_t i = 0; i < count; ++i) points.push_back(center + Vec3(one(), one(), one()));
    return points;
}

std::vector<std::uint32_t> bruteForce(const std::vector<Vec3>& points, const Vec3& query, Real radius) {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if ((points[i] - query).squaredNorm() <= radius * radius) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

std::vector<std::uint32_t> byGrid(const HashGrid& grid, const Vec3& query, Real radius) {
    std::vector<std::uint32_t> found;
    grid.within(query, radius, [&](const NearPoint& near) { found.push_back(grid.order()[near.place]); });
    std::sort(found.begin(), found.end());
    return found;
}

// At any place and scale, with radii of a tenth to thirty cells, at points, between them and outside: what brute force
// finds, each point once, whatever cells share a slot.
TEST(HashGrid, FindsWhatBruteForceFinds) {
    Random random(11, {0});
    for (const std::size_t count : {std::size_t{1}, std::size_t{7}, std::size_t{300}, std::size_t{3000}}) {
        for (const Real size : {1e-3, 1.0, 1e5}) {
            for (const Real away : {0.0, 10.0, 1e6}) {
                const Vec3 center = Vec3(1, -0.7, 0.3) * (away * size);
                const std::vector<Vec3> points = cloud(count, size, center, 1);
                const Real cell = size * 0.1;
                const HashGrid grid(points, cell);
                for (int trial = 0; trial < 60; ++trial) {
                    const Real radius = cell * std::pow(10, random.uniform(-1, 1.5));
                    Vec3 query = cloud(1, 1.3 * size, center, static_cast<std::uint64_t>(1000 + trial))[0];
                    if (trial % 3 == 0) query = points[random.below(points.size())];
                    ASSERT_EQ(byGrid(grid, query, radius), bruteForce(points, query, radius))
                        << count << " points of " << size << " at " << away << ", radius " << radius;
                }
            }
        }
    }
}

// Points on the borders of cells, at exactly the radius, and all at one place.
TEST(HashGrid, BordersAreInside) {
    std::vector<Vec3> points;
    for (int x = -4; x <= 4; ++x) {
        for (int y = -4; y <= 4; ++y) {
            for (int z = -4; z <= 4; ++z) points.push_back(Vec3(x, y, z) * 0.25);
        }
    }
    points.insert(points.end(), 100, Vec3(0.25, 0.25, 0.25));
    const HashGrid grid(points, 0.25);
    for (const Vec3& query : points) {
        for (const Real radius : {0.0, 0.25, 0.5, 0.75})
            ASSERT_EQ(byGrid(grid, query, radius), bruteForce(points, query, radius)) << query.transpose();
    }
}

// A wall lit by photons, asked for beyond its rim and from both sides: a grid that turns away what is outside the
// photons' box finds nothing there.
TEST(HashGrid, AsksBeyondThePhotonsBox) {
    std::vector<Vec3> wall;
    Random random(2, {2});
    for (int i = 0; i < 2000; ++i) wall.push_back(Vec3(random.uniform(0, 1), random.uniform(0, 1), 0));
    const HashGrid grid(wall, 0.1);
    std::size_t found = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 query(random.uniform(-0.05, 0), random.uniform(0, 1), random.uniform(-0.02, 0.02));
        const auto expected = bruteForce(wall, query, 0.05);
        found += expected.size();
        ASSERT_EQ(byGrid(grid, query, 0.05), expected);
    }
    EXPECT_GT(found, 1000U);
}

// A few points in a table of a few slots, asked for by many cells: collisions are the rule.
TEST(HashGrid, CollisionsCountOnce) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const std::vector<Vec3> points = cloud(5, 1, Vec3::Zero(), seed);
        const HashGrid grid(points, 0.3);
        for (const Real radius : {0.2, 0.31, 0.6, 5.0}) {
            const Vec3 query = cloud(1, 1, Vec3::Zero(), seed + 1'000'000)[0];
            ASSERT_EQ(byGrid(grid, query, radius), bruteForce(points, query, radius)) << seed;
        }
    }
}

// Far out, and for radii without end, integers would overflow.
TEST(HashGrid, TakesEveryFiniteNumber) {
    const std::vector<Vec3> points = {{1e300, 0, 0}, {-1e300, 1e300, 5},  {0, 0, 0},
                                      {1, 2, 3},     {1e18, 1e18, -1e18}, {5e-324, 0, 0}};
    for (const Real cell : {1e-12, 1.0, 1e290}) {
        const HashGrid grid(points, cell);
        for (const Vec3& query : points) {
            for (const Real radius : {0.0, 1e-3, 4.0, 1e19, 1e100})
                ASSERT_EQ(byGrid(grid, query, radius), bruteForce(points, query, radius)) << query.transpose();
        }
        constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
        constexpr Real infinity = std::numeric_limits<Real>::infinity();
        EXPECT_TRUE(byGrid(grid, {nan, 0, 0}, 1).empty());
        EXPECT_TRUE(byGrid(grid, {0, 0, 0}, -1).empty());
        EXPECT_TRUE(byGrid(grid, {0, 0, 0}, nan).empty());
        EXPECT_EQ(byGrid(grid, {0, 0, 0}, infinity).size(), points.size());
    }
}

TEST(HashGrid, RefusesWhatIsNoGrid) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const std::vector<Vec3> points = {{0, 0, 0}};
    for (const Real cell : {0.0, -1.0, nan, infinity, 1e-320}) EXPECT_THROW(HashGrid(points, cell), InputError) << cell;
    for (const Real bad : {nan, infinity}) {
        const std::vector<Vec3> worse = {{0, 0, 0}, {0, bad, 0}};
        EXPECT_THROW(HashGrid(worse, 1), InputError) << bad;
    }
    const HashGrid empty(std::span<const Vec3>(), 1);
    EXPECT_EQ(empty.size(), 0U);
    EXPECT_TRUE(byGrid(empty, {0, 0, 0}, 10).empty());
}

}  // namespace
}  // namespace caustic
