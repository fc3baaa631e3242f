#include <gtest/gtest.h>

#include "shape/cramer.h"
#include "triangle_cases.h"

namespace caustic {
namespace {

using test::frontCase;
using test::sizes;
using test::TriangleCase;

// Points that are chosen by their barycentric coordinates: inside when both are positive and sum to less than 1.
TEST(Cramer, HitsInsideAndMissesOutside) {
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const TriangleCase one = frontCase(i);
        const auto found = intersectCramer(one.ray, one.a, one.b, one.c);
        ASSERT_EQ(found.has_value(), one.hits)
            << "b1 = " << one.b1 << ", b2 = " << one.b2 << ", size " << sizes[i % sizes.size()]
            << ": are all three edges looked at, the one opposite a too, and is a small triangle still one?";
        if (!found) continue;
        EXPECT_NEAR(found->t, one.t, 1e-11 * one.t) << "Which determinant belongs to t?";
        EXPECT_NEAR(found->b1, one.b1, 1e-11);
        EXPECT_NEAR(found->b2, one.b2, 1e-11);
    }
}

// The triangle (0, 0), (1, 0), (0, 1) in a plane, where all is exact: a ray down on a point of it or beside it.
template <typename Intersect>
void expectBordersBelong(const Intersect& intersect) {
    const Vec3 a = Vec3::Zero();
    const Vec3 b = Vec3::UnitX();
    const Vec3 c = Vec3::UnitY();
    for (const Real height : {1.0, -1.0}) {
        for (const Vec2& at : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(0.5, 0), Vec2(0, 0.5), Vec2(0.5, 0.5)}) {
            const Ray ray = {Vec3(at.x(), at.y(), height), Vec3(0, 0, -height)};
            EXPECT_TRUE(intersect(ray, a, b, c)) << at.transpose() << ": do edges and corners belong to a triangle?";
            EXPECT_TRUE(intersect(ray, b, a, c)) << at.transpose() << ": and seen from the other side?";
        }
        for (const Vec2& at : {Vec2(-0.5, 0), Vec2(2, 0), Vec2(2, -1), Vec2(0, -0.5), Vec2(0.75, 0.5), Vec2(-1, 2)}) {
            const Ray ray = {Vec3(at.x(), at.y(), height), Vec3(0, 0, -height)};
            EXPECT_FALSE(intersect(ray, a, b, c)) << at.transpose();
        }
    }
}

// A triangle has two sides, and a ray two ends.
TEST(Cramer, BothSidesCountAndBothEndsOfTheRay) {
    const auto intersect = [](const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
        return intersectCramer(ray, a, b, c);
    };
    expectBordersBelong(intersect);
    test::expectSignOfT(intersect);
    for (std::uint64_t i = 0; i < 1000; ++i) {
        TriangleCase one = frontCase(i);
        if (!one.hits) continue;
        EXPECT_TRUE(intersectCramer(one.ray, one.a, one.c, one.b)) << "Does a negative determinant count as a miss?";
        Ray part = one.ray;
        part.tMax = one.t * (1 - 1e-6);
        EXPECT_FALSE(intersectCramer(part, one.a, one.b, one.c)) << "Is tMax heeded?";
        part = one.ray;
        part.tMin = one.t * (1 + 1e-6);
        EXPECT_FALSE(intersectCramer(part, one.a, one.b, one.c)) << "Is tMin heeded?";
    }
}

}  // namespace
}  // namespace caustic
