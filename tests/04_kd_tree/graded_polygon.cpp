#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/polygon.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using Corners = std::vector<Vec3>;

// A plane somewhere in space, with a unit of length of its own.
struct Placement {
    explicit Placement(std::uint64_t i) {
        Random random(12, {i});
        if (i > 0) {
            turn = Eigen::AngleAxis<Real>(random.uniform(0, 6), test::inCube(random).normalized()).toRotationMatrix();
            size = std::pow(10, random.uniform(-6, 6));
            origin = 3 * size * test::inCube(random);
        }
    }

    Corners of(const Corners& drawn) const {
        Corners placed;
        for (const Vec3& corner : drawn) placed.push_back(size * (turn * corner) + origin);
        return placed;
    }

    // Positive for a triangle that goes round counterclockwise as drawn, in units of the drawing.
    Real areaOf(const Corners& placed, const std::array<std::uint32_t, 3>& triangle) const {
        const auto& [a, b, c] = triangle;
        return ((placed[b] - placed[a]) / size).cross((placed[c] - placed[a]) / size).dot(turn.col(2)) / 2;
    }

    Eigen::Matrix<Real, 3, 3> turn = Eigen::Matrix<Real, 3, 3>::Identity();
    Real size = 1;
    Vec3 origin = Vec3::Zero();
};

// An arrow's head, an L, a comb, and a hexagon: signed areas must be positive and sum to the polygon's.
TEST(Triangulated, CoversPolygonsOnce) {
    const std::vector<Corners> polygons = {
        {Vec3(0, 0, 0), Vec3(2, -1, 0), Vec3(0.5, 0, 0), Vec3(2, 1, 0)},
        {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(0, 2, 0)},
        {Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(5, 3, 0), Vec3(4, 3, 0), Vec3(4, 1, 0), Vec3(3, 1, 0), Vec3(3, 3, 0),
         Vec3(2, 3, 0), Vec3(2, 1, 0), Vec3(1, 1, 0), Vec3(1, 3, 0), Vec3(0, 3, 0)},
        {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(3, 1, 0), Vec3(2.5, 2, 0), Vec3(1, 2, 0), Vec3(0, 1, 0)}};
    const std::array<Real, 4> areas = {0.5, 3, 11, 4.75};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::uint64_t place = 0; place < 20; ++place) {
            const Placement placement(place);
            for (std::size_t turn = 0; turn < polygons[i].size(); ++turn) {
                Corners corners = placement.of(polygons[i]);
                std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(turn), corners.end());
                const auto triangles = triangulated(corners);
                ASSERT_EQ(triangles.size(), corners.size() - 2);
                Real sum = 0;
                for (const auto& triangle : triangles) {
                    ASSERT_GE(placement.areaOf(corners, triangle), -1e-12)
                        << "polygon " << i << ": which corner is no ear?";
                    sum += std::abs(placement.areaOf(corners, triangle));
                }
                ASSERT_NEAR(sum, areas[i], 1e-12) << "polygon " << i << ": do triangles overlap?";
            }
        }
    }
}

// Whichever way a polygon is seen, its triangles go round as it does; one that crosses itself still has n - 2.
TEST(Triangulated, KeepsTheWayRoundAndEndsAlways) {
    const Corners head = {Vec3(0, 0, 0), Vec3(2, -1, 0), Vec3(0.5, 0, 0), Vec3(2, 1, 0)};
    const Corners square = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    for (const Corners& drawn : {head, square}) {
        const Corners reversed(drawn.rbegin(), drawn.rend());
        for (std::uint64_t place = 0; place < 20; ++place) {
            const Placement placement(place);
            const Corners corners = placement.of(reversed);
            for (const auto& triangle : triangulated(corners)) {
                EXPECT_LE(placement.areaOf(corners, triangle), 0) << "Seen from behind.";
            }
        }
    }
    const Corners crossing = {Vec3(0, 0, 0), Vec3(2, 2, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(-1, 1, 0)};
    EXPECT_EQ(triangulated(crossing).size(), 3U);
    // Once the larger loop is cut off, the smaller one, which runs the other way, has no ear.
    const Corners eight = {Vec3(-6, 3, 0),  Vec3(-6, -3, 0),  Vec3(3, 1.5, 0),
                           Vec3(4, 0.5, 0), Vec3(4, -0.5, 0), Vec3(3, -1.5, 0)};
    EXPECT_EQ(triangulated(eight).size(), 4U) << "What is cut off where no corner is an ear?";
    // Whatever is cut off, the triangles' signed areas sum to the polygon's, and every corner is in some triangle.
    for (std::uint64_t i = 0; i < 600; ++i) {
        Random random(14, {i});
        Corners corners;
        for (std::size_t k = 0; k < 4 + i % 9; ++k)
            corners.push_back(Vec3(random.uniform(-3, 3), random.uniform(-2, 2), 0));
        Real twice = 0;
        for (std::size_t k = 0; k < corners.size(); ++k)
            twice += corners[k].cross(corners[(k + 1) % corners.size()]).z();
        const auto triangles = triangulated(corners);
        ASSERT_EQ(triangles.size(), corners.size() - 2);
        Real sum = 0;
        std::vector<bool> used(corners.size(), false);
        for (const auto& triangle : triangles) {
            for (const std::uint32_t corner : triangle) {
                ASSERT_LT(corner, corners.size()) << "Which corner follows the last one?";
                used[corner] = true;
            }
            sum += 2 * Placement(0).areaOf(corners, triangle);
        }
        ASSERT_NEAR(sum, twice, 1e-12) << "polygon " << i << ": which corner was cut off, and is the ring closed?";
        ASSERT_TRUE(std::ranges::all_of(used, [](bool one) { return one; })) << "polygon " << i;
    }
    const Corners point(6, Vec3::Ones());
    EXPECT_EQ(triangulated(point).size(), 4U) << "A polygon without area must not stop the reader.";
}

// A fan around the first corner, as the reader of a file of convex polygons may rely on.
TEST(Triangulated, FansAConvexPolygonOut) {
    Corners round;
    for (int i = 0; i < 3000; ++i) round.push_back(Vec3(std::cos(2e-3 * i), 0.3, std::sin(2e-3 * i)));
    const auto triangles = triangulated(round);
    ASSERT_EQ(triangles.size(), 2998U);
    for (std::uint32_t i = 0; i < 2998; ++i) {
        const std::array<std::uint32_t, 3> expected = {0, i + 1, i + 2};
        ASSERT_EQ(triangles[i], expected) << "Triangle " << i << " of a convex polygon: which corner is the fan's?";
    }
}

}  // namespace
}  // namespace caustic
