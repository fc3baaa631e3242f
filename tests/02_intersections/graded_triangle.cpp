#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

#include "shape/cramer.h"
#include "shape/watertight.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

struct TriangleCase {
    Vec3 a, b, c;
    Ray ray;
    bool hits;  // by construction
    Real b1, b2;
    Real t;
};

// A ray aimed at a chosen point of the triangle's plane, from the side that sees a, b, c counterclockwise.
TriangleCase frontCase(std::uint64_t i) {
    Random random(1, {i});
    TriangleCase one;
    one.a = inCube(random);
    one.b = one.a + Vec3(2, 0.2, 0.1) + 0.3 * inCube(random);
    one.c = one.a + Vec3(0.3, 2, -0.2) + 0.3 * inCube(random);
    one.b1 = random.uniform(-0.5, 1.5);
    one.b2 = random.uniform(-0.5, 1.5);
    one.hits = one.b1 > 0 && one.b2 > 0 && one.b1 + one.b2 < 1;
    one.t = random.uniform(0.5, 2);
    const Vec3 target = (1 - one.b1 - one.b2) * one.a + one.b1 * one.b + one.b2 * one.c;
    const Vec3 direction = Vec3(0, 0, -3) + inCube(random);
    one.ray = {target - one.t * direction, direction};
    return one;
}

// Points that are chosen by their barycentric coordinates: inside when both are positive and sum to less than 1.
TEST(Cramer, HitsInsideAndMissesOutside) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const TriangleCase one = frontCase(i);
        const auto found = intersectCramer(one.ray, one.a, one.b, one.c);
        ASSERT_EQ(found.has_value(), one.hits)
            << "b1 = " << one.b1 << ", b2 = " << one.b2 << ": are all three edges looked at, the one opposite a too?";
        if (!found) continue;
        EXPECT_NEAR(found->t, one.t, 1e-11) << "Which determinant belongs to t?";
        EXPECT_NEAR(found->b1, one.b1, 1e-11);
        EXPECT_NEAR(found->b2, one.b2, 1e-11);
    }
}

// A triangle has two sides, and a ray two ends.
TEST(Cramer, BothSidesCountAndBothEndsOfTheRay) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        TriangleCase one = frontCase(i);
        if (!one.hits) continue;
        EXPECT_TRUE(intersectCramer(one.ray, one.a, one.c, one.b)) << "Does a negative determinant count as a miss?";
        Ray part = one.ray;
        part.tMax = one.t - 1e-6;
        EXPECT_FALSE(intersectCramer(part, one.a, one.b, one.c)) << "Is tMax heeded?";
        part = one.ray;
        part.tMin = one.t + 1e-6;
        EXPECT_FALSE(intersectCramer(part, one.a, one.b, one.c)) << "Is tMin heeded?";
    }
}

TEST(Watertight, HitsInsideAndMissesOutside) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const TriangleCase one = frontCase(i);
        const auto found = intersectWatertight(ShearedRay(one.ray), one.a, one.b, one.c);
        ASSERT_EQ(found.has_value(), one.hits) << "b1 = " << one.b1 << ", b2 = " << one.b2;
        if (!found) continue;
        EXPECT_NEAR(found->t, one.t, 1e-11);
        EXPECT_NEAR(found->b1, one.b1, 1e-11) << "u belongs to a, v to b, w to c: which two are asked for?";
        EXPECT_NEAR(found->b2, one.b2, 1e-11);
    }
}

// A closed mesh: an octahedron with random corners around the origin, where the rays start.
struct Octahedron {
    std::array<Vec3, 6> corners;
    std::vector<std::array<std::size_t, 3>> faces;
};

Octahedron randomOctahedron(Random& random) {
    Octahedron mesh;
    for (std::size_t i = 0; i < 6; ++i) {
        const Vec3 axis = (i % 2 == 0 ? 1 : -1) * Vec3::Unit(static_cast<int>(i / 2));
        mesh.corners[i] = random.uniform(0.7, 1.3) * axis + 0.2 * inCube(random);
    }
    for (const std::size_t x : {0, 1}) {
        for (const std::size_t y : {2, 3}) {
            for (const std::size_t z : {4, 5}) mesh.faces.push_back({x, y, z});
        }
    }
    return mesh;
}

// From inside a closed mesh there is no way out: whatever edge or corner a ray is aimed at, it hits a triangle there.
TEST(Watertight, NothingLeaksThroughSharedEdgesAndVertices) {
    for (std::uint64_t i = 0; i < 200'000; ++i) {
        Random random(2, {i});
        const Octahedron mesh = randomOctahedron(random);
        const std::size_t from = random.below(6);
        const std::size_t to = (from + (from % 2 == 0 ? 2 : 1) + random.below(4)) % 6;
        if (to / 2 == from / 2) continue;  // opposite corners share no edge
        const Real share = random.below(4) == 0 ? 0 : random.uniform();
        const Vec3 target = mesh.corners[from] + share * (mesh.corners[to] - mesh.corners[from]);
        const Vec3 origin = 0.05 * inCube(random);
        const ShearedRay ray(Ray{origin, target - origin});
        bool hit = false;
        for (const auto& [a, b, c] : mesh.faces) {
            hit = hit || intersectWatertight(ray, mesh.corners[a], mesh.corners[b], mesh.corners[c]);
        }
        ASSERT_TRUE(hit) << "Ray " << i << " got out: on which side of an edge does zero count, and is each difference "
                         << "of products the exact negative of its neighbour's?";
    }
}

// A ray that starts 1024 machine epsilons off a triangle and goes away from it is off it, however thin the triangle.
TEST(Watertight, SliverIsNotHitByARayThatLeavesIt) {
    const Vec3 a(-1, -0.9, 0.1);
    const Vec3 b(1, 0.7, -0.4);
    const Vec3 c(0.2, 0.0601, -0.2);
    const Vec3 normal = (b - a).cross(c - a).normalized();
    for (std::uint64_t i = 0; i < 50'000; ++i) {
        Random random(3, {i});
        const Real b1 = random.uniform();
        const Real b2 = random.uniform(0, 1 - b1);
        const Vec3 origin = (1 - b1 - b2) * a + b1 * b + b2 * c + 0x1p-42 * normal;
        Vec3 direction = inCube(random);
        if (direction.dot(normal) < 0) direction = -direction;
        ASSERT_FALSE(intersectWatertight(ShearedRay(Ray{origin, direction}), a, b, c))
            << "Is the numerator of t trusted although its rounding error is larger than itself?";
    }
}

}  // namespace
}  // namespace caustic
