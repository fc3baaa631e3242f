#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

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
        const Real size = std::pow(10, random.uniform(-6, 6));
        const Vec3 toCenter = 3 * size * inCube(random);
        const Vec3 direction = size * std::pow(10, random.uniform(-2, 2)) * inCube(random);
        const Vec3 unit = direction.normalized();
        const Real radius = size * random.uniform(0.1, 2);
        const Real distance = (toCenter - toCenter.dot(unit) * unit).norm();
        const Interval found = ballInterval<Real, 3>(toCenter, direction, radius);
        ASSERT_EQ(!found.empty(), distance <= radius)
            << "Is the line taken as a whole, with what lies behind t = 0, and is a miss an empty interval?";
        if (found.empty()) {
            ASSERT_EQ(found.lower, std::numeric_limits<Real>::infinity()) << "What is a miss, NaN aside?";
            ASSERT_EQ(found.upper, -std::numeric_limits<Real>::infinity());
            continue;
        }
        ++hits;
        ASSERT_LE(found.lower, found.upper);
        for (const Real t : {found.lower, found.upper}) {
            ASSERT_NEAR((t * direction - toCenter).norm(), radius, 1e-12 * size)
                << "Is t counted in lengths of the direction, whatever they are?";
        }
    }
    EXPECT_GT(hits, 500);
    const Interval touching = ballInterval<Real, 3>(Vec3(2, 3, 0), Vec3::UnitX(), 3.0);
    EXPECT_EQ(touching.lower, 2) << "A closed ball: does a line that touches it meet it?";
    EXPECT_EQ(touching.upper, 2);
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
    EXPECT_FALSE((ballInterval<Real, 2>(Vec2(3, -4), none, 5.0).empty())) << "A closed disc: on its border, too.";
    const Interval never = ballInterval<Real, 2>(Vec2(0.3, -0.4), none, 0.49);
    EXPECT_EQ(never.lower, std::numeric_limits<Real>::infinity());
    EXPECT_EQ(never.upper, -std::numeric_limits<Real>::infinity());
}

}  // namespace
}  // namespace caustic
