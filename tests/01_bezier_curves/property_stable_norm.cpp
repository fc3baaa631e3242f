#include "math/stable_norm.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"

namespace caustic {
namespace {

Vec3 anyVector(Random& random) {
    return {random.uniform() - 0.3, 40 * random.uniform() - 3, -0.002 * random.uniform()};
}

TEST(StableNorm, IsTheSameNumberWhereverTheVectorLies) {
    Random random(7101, {0});
    for (int i = 0; i < 2000; ++i) {
        const Vec3 v = anyVector(random);
        const Real length = stableNorm(v);
        // Neighbours of odd size in one array: the middle one begins at another place of a cache line each time.
        std::array<Vec3, 5> copies;
        copies.fill(v);
        for (const Vec3& copy : copies)
            ASSERT_EQ(stableNorm(copy), length) << "Does the order of the sum depend on the address?";
    }
}

TEST(StableNorm, AgreesWithHypotAtEveryScale) {
    Random random(7102, {0});
    for (int exponent = -1070; exponent <= 1010; exponent += 20) {
        const Vec3 v = anyVector(random);
        const Vec3 scaled = {std::scalbn(v.x(), exponent), std::scalbn(v.y(), exponent), std::scalbn(v.z(), exponent)};
        const Real expected = std::hypot(scaled.x(), scaled.y(), scaled.z());
        const Real tolerance =
            4 * std::numeric_limits<Real>::epsilon() * expected + std::numeric_limits<Real>::denorm_min();
        EXPECT_NEAR(stableNorm(scaled), expected, tolerance)
            << "Does a square over- or underflow at 2^" << exponent << "?";
    }
}

TEST(StableNorm, TellsZeroAndWhatIsNotFinite) {
    const Real infinity = std::numeric_limits<Real>::infinity();
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(stableNorm(Vec3(0, -0.0, 0)), 0);
    EXPECT_EQ(stableNorm(Vec3(1, -infinity, 2)), infinity);
    EXPECT_TRUE(std::isnan(stableNorm(Vec3(1, 2, nan))));
    EXPECT_TRUE(std::isnan(stableNorm(Vec3(nan, 2, 1))));
}

TEST(StableNorm, TakesVectorsOfThePlaneAndExpressions) {
    const Vec3 v(3, -4, 12);
    EXPECT_EQ(stableNorm(v.head<2>()), 5);
    EXPECT_EQ(stableNorm(v - Vec3(0, 0, 0)), 13);
}

}  // namespace
}  // namespace caustic
