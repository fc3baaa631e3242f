#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "math/ray.h"
#include "support/in_cube.h"

namespace caustic::test {

/// A ray and a triangle, and what is known of them by construction.
struct TriangleCase {
    Vec3 a, b, c;  ///< counterclockwise for who looks along the ray
    Ray ray;       ///< towards a point of the triangle's plane
    bool hits;     ///< whether that point is in the triangle
    Real b1, b2;   ///< its barycentric coordinates of b and c
    Real t;        ///< where the ray reaches it
};

//// Triangles of every size, and rays along every axis, either way, with directions of any length.
inline constexpr std::array<Real, 4> sizes = {1, 1e-6, 1e6, 1e-3};

/// A ray aimed at a chosen point of the triangle's plane, from the side that sees a, b, c counterclockwise.
inline TriangleCase frontCase(std::uint64_t i) {
    Random random(1, {i});
    const Real size = sizes[i % sizes.size()];
    const std::uint64_t turns = random.below(3);
    const Real mirror = random.below(2) == 0 ? 1 : -1;
    // A turn of the axes, and a half turn around x, keep the way round.
    const auto placed = [&](const Vec3& p) {
        const Vec3 q = size * Vec3(p.x(), mirror * p.y(), mirror * p.z());
        return turns == 0 ? q : (turns == 1 ? Vec3(q.y(), q.z(), q.x()) : Vec3(q.z(), q.x(), q.y()));
    };
    const Vec3 a = inCube(random);
    TriangleCase one;
    one.a = placed(a);
    one.b = placed(a + Vec3(2, 0.2, 0.1) + 0.3 * inCube(random));
    one.c = placed(a + Vec3(0.3, 2, -0.2) + 0.3 * inCube(random));
    one.b1 = random.uniform(-0.5, 1.5);
    one.b2 = random.uniform(-0.5, 1.5);
    one.hits = one.b1 > 0 && one.b2 > 0 && one.b1 + one.b2 < 1;
    const Vec3 target = (1 - one.b1 - one.b2) * one.a + one.b1 * one.b + one.b2 * one.c;
    const Vec3 way = placed(Vec3(0, 0, -3) + inCube(random));
    const Real length = std::pow(10, random.uniform(-3, 3)) / size;
    one.t = random.uniform(0.5, 2) / length;
    one.ray = {target - one.t * length * way, length * way};
    return one;
}

/// A triangle behind the ray's origin is met only by a ray that begins even farther behind.
template <typename Intersect>
void expectSignOfT(const Intersect& intersect) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const TriangleCase one = frontCase(i);
        if (!one.hits) continue;
        Ray away = {one.ray.at(2 * one.t), one.ray.direction};
        ASSERT_FALSE(intersect(away, one.a, one.b, one.c)) << "The triangle lies behind: which sign has t?";
        away.tMin = -2 * one.t;
        const auto found = intersect(away, one.a, one.b, one.c);
        ASSERT_TRUE(found) << "tMin may be negative.";
        ASSERT_NEAR(found->t, -one.t, 1e-11 * one.t);
    }
}

}  // namespace caustic::test
