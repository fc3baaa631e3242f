#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "medium/absorbing_medium.h"

namespace caustic {
namespace {

// Beer–Lambert: e^(−σ d).
TEST(Absorption, FollowsBeerLambert) {
    const AbsorbingMedium medium(Color(0.1, 1, 5));
    for (const Real distance : {0.0, 0.01, 1.0, 3.0}) {
        const Color passed = medium.transmittance({Vec3(1, 2, 3), Vec3::UnitY()}, distance);
        EXPECT_NEAR(passed.x(), std::exp(-0.1 * distance), 1e-14);
        EXPECT_NEAR(passed.y(), std::exp(-distance), 1e-14);
        EXPECT_NEAR(passed.z(), std::exp(-5 * distance), 1e-14)
            << "Twice the way lets the square of the share pass, not twice as little.";
    }
}

// t counts in lengths of the ray's direction, the coefficient in metres.
TEST(Absorption, CountsMetresWhateverTheDirectionsLength) {
    const AbsorbingMedium medium(Color::Constant(0.5));
    for (const Real length : {5.0, 0.04}) {
        for (int octant = 0; octant < 8; ++octant) {
            const Vec3 way((octant & 1) != 0 ? 0.48 : -0.48, (octant & 2) != 0 ? 0.6 : -0.6,
                           (octant & 4) != 0 ? 0.64 : -0.64);
            EXPECT_NEAR(medium.transmittance({Vec3(9, 1, 2), length * way}, 2).x(), std::exp(-length), 1e-14)
                << "How many metres is t = 2 when the direction is " << length << " metres long?";
        }
    }
}

// A green glass lets all green pass, as far as one looks.
TEST(Absorption, AClearChannelPassesAnyDistance) {
    const AbsorbingMedium medium(Color(1, 0, 1));
    const Color passed = medium.transmittance({Vec3::Zero(), Vec3::UnitX()}, std::numeric_limits<Real>::infinity());
    EXPECT_EQ(passed.y(), 1) << "What is 0 · ∞?";
    EXPECT_LT(passed.x(), 1e-300);
    EXPECT_LT(passed.z(), 1e-300);
    const Color little = AbsorbingMedium(Color(0, 1e-9, 0)).transmittance({Vec3::Zero(), Vec3::UnitX()}, 3e8);
    EXPECT_NEAR(little.y(), std::exp(-0.3), 1e-14) << "Is little absorption none?";
    EXPECT_EQ(little.x(), 1);
}

}  // namespace
}  // namespace caustic
