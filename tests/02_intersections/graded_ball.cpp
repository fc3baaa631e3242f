#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "shape/ball.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// Both ends are on the sphere by definition; a line whose distance from the centre is more than the radius misses.
TEST(Ball, EndsAreOnTheSphereForAnyLengthOfDirection) {
    int hits = 0;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        Random random(1, {i});
        const Vec3 toCenter = 3 * inCube(random);
        const Vec3 direction = std::pow(10, random.uniform(-2, 2)) * inCube(random);
        const Vec3 unit = direction.normalized();
        const Real radius = random.uniform(0.1, 2);
        const Real distance = (toCenter - toCenter.dot(unit) * unit).norm();
        const Interval found = ballInterval<Real, 3>(toCenter, direction, radius);
        ASSERT_EQ(!found.empty(), distance <= radius)
            << "Is the line taken as a whole, with what lies behind t = 0, and is a miss an empty interval?";
        if (found.empty()) continue;
        ++hits;
        ASSERT_LE(found.lower, found.upper);
        for (const Real t : {found.lower, found.upper}) {
            ASSERT_NEAR((t * direction - toCenter).norm(), radius, 1e-12)
                << "Is t counted in lengths of the direction, whatever they are?";
        }
    }
    EXPECT_GT(hits, 500);
}

// 10⁷ radii away; the chord's half length is √(r² - a²) at a distance a from the centre.
TEST(Ball, FarSphereKeepsItsDigits) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Vec3 direction = inCube(random).normalized();
        const Vec3 across = direction.unitOrthogonal();
        const Real aside = random.uniform(0, 0.9);
        const Interval found = ballInterval<Real, 3>(1e7 * direction + aside * across, direction, 1.0);
        ASSERT_FALSE(found.empty());
        // The direction's own rounding moves the line by some 1e-9 there.
        EXPECT_NEAR((found.upper - found.lower) / 2, std::sqrt(1 - aside * aside), 1e-6)
            << "Which two numbers of the size of 10¹⁴ are subtracted from each other?";
    }
}

// In the plane the ball is a cylinder seen along its axis, and a line along the axis has no direction left.
TEST(Ball, LineAlongACylindersAxisIsInItAlwaysOrNever) {
    const Vec2 none(0, -0.0);
    const Interval always = ballInterval<Real, 2>(Vec2(0.3, -0.4), none, 0.51);
    EXPECT_FALSE(always.empty()) << "What is the length of the direction divided by?";
    EXPECT_EQ(always.lower, -std::numeric_limits<Real>::infinity());
    EXPECT_EQ(always.upper, std::numeric_limits<Real>::infinity());
    EXPECT_TRUE((ballInterval<Real, 2>(Vec2(0.3, -0.4), none, 0.49).empty()));
}

}  // namespace
}  // namespace caustic
