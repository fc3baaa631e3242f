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
    EXPECT_NEAR(medium.transmittance({Vec3::Zero(), Vec3(0, 3, 4)}, 2).x(), std::exp(-5), 1e-14)
        << "How many metres is t = 2 when the direction is 5 metres long?";
}

// A green glass lets all green pass, as far as one looks.
TEST(Absorption, AClearChannelPassesAnyDistance) {
    const AbsorbingMedium medium(Color(1, 0, 1));
    const Color passed = medium.transmittance({Vec3::Zero(), Vec3::UnitX()}, std::numeric_limits<Real>::infinity());
    EXPECT_EQ(passed.y(), 1) << "What is 0 · ∞?";
    EXPECT_EQ(passed.x(), 0);
}

}  // namespace
}  // namespace caustic
