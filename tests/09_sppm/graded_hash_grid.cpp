#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
        points.push_back(
            {random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()), random.uniform(low.z(), high.z())});
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
        const Vec3 query =
            cloud(1, low + Vec3(0.1, 0.1, 0.1), low + Vec3(1.9, 0.9, 0.4), 50U + static_cast<unsigned>(trial))[0];
        const Real radius = 0.01 * std::pow(30, random.uniform(0, 1));
        ASSERT_EQ(unique(visited(grid, query, radius)), bruteForce(points, query, radius))
            << "radius " << radius << ": Which cubes does the ball reach into? Is the border inside?";
    }

    // Far out, where cubes have large numbers; and a point's own distance is a radius that reaches it, just less
    // doesn't.
    const Vec3 away(-7e6, 3e6, 1e7);
    const std::vector<Vec3> far = cloud(500, away, away + Vec3::Ones(), 4);
    const HashGrid distant(far, 0.1);
    for (std::size_t i = 0; i + 1 < far.size(); ++i) {
        const Real radius = (far[i + 1] - far[i]).norm();
        for (const Real reach : {radius * (1 + 1e-12), radius * (1 - 1e-12)}) {
            ASSERT_EQ(unique(visited(distant, far[i], reach)), bruteForce(far, far[i], reach))
                << "In which cubes may a point lie that is as far as that?";
        }
    }

    // On the border, as far as numbers can tell: 1 − (−6·10⁻¹⁷) is 1, and −6·10⁻¹⁷ + 1 is less than that. Others lie
    // far away, or all would be looked at.
    std::vector<Vec3> others = cloud(2000, Vec3::Constant(50), Vec3::Constant(60), 6);
    others.push_back(Vec3::Constant(0.2));
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec3> all = others;
        Vec3 query = all.back();
        all.back()[axis] = 1;
        query[axis] = -6e-17;
        EXPECT_EQ(visited(HashGrid(all, 0.5), query, 1).size(), 1U)
            << "Rounding brings the point to the border. In which cube does it lie?";
    }
    // And as exactly as numbers can be: a quarter before the begin of a cube.
    for (const Real border : {1000.0, -1000.0}) {
        others.back() = {border, 0.2, 0.2};
        EXPECT_EQ(visited(HashGrid(others, 0.5), {border - 0.25, 0.2, 0.2}, 0.25).size(), 1U)
            << "The border is inside.";
    }
    EXPECT_EQ(visited(grid, points[7], 0), Places{7}) << "Radius 0 is a radius.";

    // 40,000 times one of 262,144 points: whoever asks all of them each time won't see the end.
    std::vector<Vec3> lattice;
    for (int i = 0; i < 64 * 64 * 64; ++i) lattice.emplace_back(i % 64 - 90, i / 64 % 64 - 80, i / 4096 - 70);
    const HashGrid large(lattice, 0.8);
    std::size_t found = 0;
    for (int i = 0; i < 40'000; ++i) {
        const std::size_t which = random.below(lattice.size());
        large.within(lattice[which] + Vec3(0.2, -0.1, 0.15), 0.4,
                     [&](const NearPoint& near) { found += large.order()[near.place] == which; });
    }
    EXPECT_EQ(found, 40'000U);
}

// So few points that the table has a handful of slots, and so many cubes asked for that most share one.
TEST(HashGrid, VisitsEachPointOnce) {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const std::vector<Vec3> points = cloud(std::size_t{6} / (1 + seed % 6), -Vec3::Ones(), Vec3::Ones(), seed);
        const HashGrid grid(points, 0.5);
        for (const Real radius : {0.05, 0.2, 0.35, 0.5}) {
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

    EXPECT_TRUE(visited(HashGrid(std::vector<Vec3>{}, 0.2), {1, 2, 3}, 5).empty()) << "No point is in an empty grid.";
    const std::vector<Vec3> spread = cloud(300, {-1, -2, -1}, {1, 2, 1}, 4);
    const HashGrid spreadGrid(spread, 0.2);
    for (const Vec3& point : spread) {
        ASSERT_TRUE(visited(spreadGrid, point, -0.01).empty() && visited(spreadGrid, point, -0.1).empty())
            << "Nothing is within a negative radius, wherever in its cube the point lies.";
    }
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real infinite = std::numeric_limits<Real>::infinity();
    EXPECT_TRUE(visited(grid, wall[0], nan).empty());
    EXPECT_TRUE(visited(grid, {0, nan, 0}, 1).empty()) << "Nothing is near what isn't finite.";
    EXPECT_TRUE(visited(grid, {infinite, 0, 0}, infinite).empty()) << "Nothing is near what isn't finite.";
    EXPECT_EQ(visited(grid, {0.1, 0.2, 0.3}, infinite).size(), wall.size()) << "All are within any distance.";
    EXPECT_EQ(visited(grid, {1e30, 0, 0}, 2e30).size(), wall.size()) << "Are there as many cubes as that?";
}

}  // namespace
}  // namespace caustic
