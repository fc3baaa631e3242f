#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "slab.h"
#include "soft_shadow.h"
#include "support/form_factor.h"

namespace caustic {
namespace {

// ∫ cos θ cos θ' / (π d²) over the lamp's part that the plate doesn't hide, by the midpoint rule.
Real shadowByQuadrature(Real x, Real z) {
    constexpr int side = 1000;
    Real sum = 0;
    for (int i = 0; i < side * side; ++i) {
        const Real u = 2 * (i % side + 0.5) / side - 1;
        const Real v = 2 * (i / side + 0.5) / side - 1;
        if (std::abs(u + x) < 1 && std::abs(v + z) < 1) continue;  // crosses height 1 within the plate
        const Real squared = 4 + (u - x) * (u - x) + (v - z) * (v - z);
        sum += 4 / (std::numbers::pi * squared * squared);
    }
    return sum * 4 / (side * side);
}

TEST(References, SoftShadowIsTheQuadraturesLimit) {
    for (const auto& [x, z] : {std::pair(0.0, 0.0), std::pair(0.4, -0.3), std::pair(1.1, 0.2), std::pair(-1.7, 1.9)})
        EXPECT_NEAR(softShadow(x, z), shadowByQuadrature(x, z), 1e-3);
    EXPECT_EQ(softShadow(0, 0), 0) << "the umbra's middle";
    // Far to the side nothing is hidden.
    EXPECT_NEAR(softShadow(2.5, 0), test::formFactor(-3.5, -1.5, -1, 1, 2), 1e-14);
}

// Reflection by reflection: each way across passes a, each face lets 1 − R pass and keeps R.
TEST(References, SlabTransmissionIsTheSumOfItsReflections) {
    for (const Real R : {0.0, 0.2, 0.9}) {
        for (const Real sigma : {0.0, 0.7}) {
            const Real a = std::exp(-sigma);
            Real inside = (1 - R) * a;
            Real sum = 0;
            for (int k = 0; k < 2000; ++k) {
                sum += inside * (1 - R);
                inside *= R * a * R * a;
            }
            EXPECT_NEAR(slabTransmission(R, sigma), sum, 1e-12);
        }
    }
}

}  // namespace
}  // namespace caustic
