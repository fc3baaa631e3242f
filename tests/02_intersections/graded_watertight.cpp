#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "shape/watertight.h"
#include "support/reference_curve.h"
#include "triangle_cases.h"

namespace caustic {
namespace {

using test::frontCase;
using test::inCube;
using test::sizes;
using test::TriangleCase;

std::optional<TriangleHit> intersect(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    return intersectWatertight(ShearedRay(ray), a, b, c);
}

TEST(Watertight, HitsInsideAndMissesOutside) {
    test::expectSignOfT(intersect);
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const TriangleCase one = frontCase(i);
        ASSERT_EQ(intersect(one.ray, one.a, one.c, one.b).has_value(), one.hits) << "A triangle has two sides.";
        const auto found = intersect(one.ray, one.a, one.b, one.c);
        ASSERT_EQ(found.has_value(), one.hits)
            << "b1 = " << one.b1 << ", b2 = " << one.b2 << ", size " << sizes[i % sizes.size()]
            << ": do signs alone decide, or does a number that is meant for large triangles?";
        if (!found) continue;
        EXPECT_NEAR(found->t, one.t, 1e-11 * one.t);
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

// The square of corners 0 to 3, cut along its diagonal, which lies on the x axis; each triangle begins with any of its
// corners. All is exact: on the diagonal its two triangles' numbers are zero.
void expectNoLeakThroughADiagonal() {
    const std::array<Vec3, 4> corners = {Vec3(-2, 0, 0), Vec3(1, -2, 0), Vec3(2, 0, 0), Vec3(-1, 2, 0)};
    const std::array<std::size_t, 3> below = {0, 1, 2};
    const std::array<std::size_t, 3> above = {2, 3, 0};
    for (std::size_t i = 0; i < 9; ++i) {
        const auto corner = [&](const std::array<std::size_t, 3>& triangle, std::size_t k) -> const Vec3& {
            return corners[triangle[k % 3]];
        };
        for (const Real height : {1.0, -1.0}) {
            for (const Real x : {-2.0, -0.5, 0.0, 1.0, 2.0}) {
                const Ray ray = {Vec3(x, 0, height), Vec3(0, 0, -height)};
                const std::size_t j = i / 3;
                EXPECT_TRUE(intersect(ray, corner(below, i), corner(below, i + 1), corner(below, i + 2)) ||
                            intersect(ray, corner(above, j), corner(above, j + 1), corner(above, j + 2)))
                    << "x = " << x << ": on which side of an edge is zero, for each of the three?";
            }
        }
    }
}

// From inside a closed mesh there is no way out: whatever edge or corner a ray is aimed at, it hits a triangle there.
TEST(Watertight, NothingLeaksThroughSharedEdgesAndVertices) {
    expectNoLeakThroughADiagonal();
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

// A sliver of any size, and a point of it: anywhere, or close to one of its corners.
struct Sliver {
    Sliver(Random& random, Real size)
        : a(size * Vec3(-1, -0.9, 0.1)), b(size * Vec3(1, 0.7, -0.4)), c(size * Vec3(0.2, 0.0601, -0.2)) {
        std::array<Real, 3> weight;
        for (Real& one : weight) one = std::pow(10, -3 * random.uniform());
        const Real sum = weight[0] + weight[1] + weight[2];
        point = (weight[0] * a + weight[1] * b + weight[2] * c) / sum;
        normal = (b - a).cross(c - a).normalized();
    }

    Vec3 a, b, c;
    Vec3 point;
    Vec3 normal;
};

constexpr std::array<Real, 3> sliverSizes = {1, 1e-12, 1e6};

// A ray that starts 1024 machine epsilons off a triangle and goes away from it is off it, however thin the triangle.
TEST(Watertight, SliverIsNotHitByARayThatLeavesIt) {
    for (std::uint64_t i = 0; i < 60'000; ++i) {
        Random random(3, {i});
        const Real size = sliverSizes[i % 3];
        const Sliver sliver(random, size);
        const Vec3 origin = sliver.point + 0x1p-42 * size * sliver.normal;
        Vec3 direction = inCube(random);
        if (direction.dot(sliver.normal) < 0) direction = -direction;
        ASSERT_FALSE(intersect({origin, direction}, sliver.a, sliver.b, sliver.c))
            << "Size " << size << ": is the numerator of t trusted although its rounding error is larger than itself?";
    }
}

// The truth about t, for numbers as they are, in twice the precision.
Real exactT(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    using Exact = Eigen::Matrix<test::Quad, 3, 1>;
    const auto exact = [](const Vec3& p) { return Exact(test::Quad(p.x()), test::Quad(p.y()), test::Quad(p.z())); };
    const auto crossed = [](const Exact& p, const Exact& q) {
        return Exact(p.y() * q.z() - p.z() * q.y(), p.z() * q.x() - p.x() * q.z(), p.x() * q.y() - p.y() * q.x());
    };
    const auto product = [](const Exact& p, const Exact& q) -> test::Quad {
        return p.x() * q.x() + p.y() * q.y() + p.z() * q.z();
    };
    const Exact from = exact(a);
    const Exact normal = crossed(exact(b) - from, exact(c) - from);
    return static_cast<Real>(
        test::Quad(product(from - exact(ray.origin), normal) / product(exact(ray.direction), normal)));
}

// The same distance off it, but towards it: it must be hit, at a t that has digits.
TEST(Watertight, SliverIsHitByARayThatStartsJustBeforeIt) {
    int hits = 0;
    for (std::uint64_t i = 0; i < 6'000; ++i) {
        Random random(4, {i});
        const Real size = sliverSizes[i % 3];
        const Sliver sliver(random, size);
        const Vec3 direction = inCube(random);
        const Real towards = direction.dot(sliver.normal);
        if (std::abs(towards) < 0.1) continue;
        const Ray ray = {sliver.point - 0x1p-42 * size / std::abs(towards) * direction, direction};
        const auto found = intersect(ray, sliver.a, sliver.b, sliver.c);
        ASSERT_TRUE(found) << "Size " << size << ": which corners' numbers does exactNumerator get?";
        const Real t = exactT(ray, sliver.a, sliver.b, sliver.c);
        ASSERT_NEAR(found->t, t, 1e-9 * t) << "Size " << size << ": what became of the digits that it has?";
        ++hits;
    }
    EXPECT_GT(hits, 3000);
}

}  // namespace
}  // namespace caustic
