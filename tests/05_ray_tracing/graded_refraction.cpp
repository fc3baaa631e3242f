#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/random.h"
#include "material/directions.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// Snell: the sines of the angles with the normal are as the indices, sin θ_o = η sin θ_i.
TEST(Refraction, SinesAreAsTheIndices) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(1, {i});
        const Vec3 n = inCube(random).normalized();
        Vec3 wo = inCube(random).normalized();
        if (wo.dot(n) < 0) wo = -wo;
        const Real eta = random.uniform(0.4, 2.5);
        const auto wi = refracted(wo, n, eta);
        if (eta < 1 && wo.cross(n).norm() > 0.999 * eta) continue;
        ASSERT_TRUE(wi) << "Into the denser medium there always is a way, out of it near the normal.";
        EXPECT_NEAR(wo.cross(n).norm(), eta * wi->cross(n).norm(), 1e-12) << "Is eta the right way up?";
        EXPECT_NEAR(wi->norm(), 1, 1e-14) << "How long is the direction?";
    }
}

// What is bent stays in the plane of wo and n, on the other side of the surface, and on the other side of the normal.
TEST(Refraction, LightGoesOnToTheOtherSide) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Vec3 n = inCube(random).normalized();
        Vec3 wo = inCube(random).normalized();
        if (wo.dot(n) < 0) wo = -wo;
        const auto wi = refracted(wo, n, random.uniform(1, 2.5));
        ASSERT_TRUE(wi);
        EXPECT_LT(wi->dot(n), 0) << "Does wi point away from the surface, on the side that wo isn't on?";
        EXPECT_NEAR(wi->dot(wo.cross(n)), 0, 1e-14);
        EXPECT_LE((wo - wo.dot(n) * n).dot(*wi), 0) << "Does light cross the normal, or turn back at it?";
    }
}

// From glass into air: beyond sin θ = η nothing gets out.
TEST(Refraction, NothingBeyondTheCriticalAngle) {
    const Real eta = 1 / 1.5;
    for (const Real sine : {eta * 1.0001, 0.8, 0.9999, 1.0}) {
        const Vec3 wo(sine, 0, std::sqrt(1 - sine * sine));
        EXPECT_FALSE(refracted(wo, Vec3::UnitZ(), eta)) << "What is the sine on the other side?";
    }
    const Real sine = eta * 0.9999;
    EXPECT_TRUE(refracted({sine, 0, std::sqrt(1 - sine * sine)}, Vec3::UnitZ(), eta));
    EXPECT_FALSE(refracted(Vec3::UnitX(), Vec3::UnitZ(), 1)) << "And at the critical angle itself?";
    for (const Real dense : {1.0001, 1.5, 30.0})
        EXPECT_TRUE(refracted(Vec3::UnitX(), Vec3::UnitZ(), dense)) << "Into the denser medium there always is a way.";
}

}  // namespace
}  // namespace caustic
