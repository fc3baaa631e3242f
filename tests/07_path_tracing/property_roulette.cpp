#include <gtest/gtest.h>

#include "integrator/roulette.h"

namespace caustic {
namespace {

// The mean of what survivors are multiplied by, over all u, is 1: what roulette takes from some it gives to others. As
// many survive as the largest channel says.
TEST(Roulette, KeepsTheMean) {
    constexpr int n = 100'000;
    for (const Real share : {0.013, 0.25, 0.5, 0.83, 0.99}) {
        for (int channel = 0; channel < 3; ++channel) {
            Color carried(0.1 * share, 0, 0.7 * share);
            carried[channel] = share;
            Real sum = 0;
            int survivors = 0;
            for (int i = 0; i < n; ++i) {
                const auto survivor = roulette(carried, (i + 0.5) / n);
                if (!survivor) continue;
                sum += *survivor;
                ++survivors;
            }
            EXPECT_NEAR(sum / n, 1, 2 / (share * n)) << "Does a survivor count for those that ended?";
            EXPECT_NEAR(survivors, share * n, 2) << "How many paths end?";
        }
    }
    for (const Real u : {0.01, 0.99}) {
        const auto survivor = roulette(Color(0.1, 0.3, 0.2), u);
        EXPECT_NEAR(survivor.value_or(1 / 0.3), 1 / 0.3, 1e-12) << "Does a survivor count for those that ended?";
    }
    EXPECT_FALSE(roulette(Color::Zero(), 0)) << "Can a path go on that carries nothing?";
}

// The largest channel decides, so that no colour is ever multiplied up beyond what it set out with; and what carries as
// much as at its start, or more, has nothing to lose.
TEST(Roulette, SparesWhatCarriesMuch) {
    for (const Real u : {0.0, 0.3, 0.999}) {
        for (const Color& share : {Color(1, 0, 0), Color(0, 0.5, 1.7), Color(40, 1, 1)}) {
            const auto survivor = roulette(share, u);
            ASSERT_TRUE(survivor) << "Does it ask the largest channel?";
            EXPECT_EQ(*survivor, 1) << "Is a probability above 1 taken for one?";
        }
    }
}

}  // namespace
}  // namespace caustic
