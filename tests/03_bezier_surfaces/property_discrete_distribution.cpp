// The choice among weighted things, whatever the weights.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/random.h"
#include "sampling/discrete_distribution.h"
#include "support/chi_square.h"

namespace caustic {
namespace {

constexpr Real belowOne = 1 - 0x1p-53;

TEST(DiscreteDistribution, ChoosesInProportion) {
    const std::vector<Real> weights = {3, 0, 0.5, 17, 1e-3, 0, 0, 4.25, 1, 0};
    const DiscreteDistribution distribution(weights);
    ASSERT_EQ(distribution.size(), weights.size());
    EXPECT_DOUBLE_EQ(distribution.sum(), 25.751);
    constexpr int samples = 200'000;
    std::vector<double> observed(weights.size(), 0);
    std::vector<double> expected;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_NEAR(distribution.probability(i), weights[i] / 25.751, 1e-15);
        expected.push_back(samples * weights[i] / 25.751);
    }
    Random random(41, {});
    for (int i = 0; i < samples; ++i) ++observed[distribution.index(random.uniform())];
    EXPECT_GT(test::chiSquareProbability(observed, expected), 1e-6);
    for (const std::size_t never : {1U, 5U, 6U, 9U}) EXPECT_EQ(observed[never], 0) << never;
}

// What is left of the number is uniform, and doesn't depend on what it chose.
TEST(DiscreteDistribution, LeavesANumberThatCanBeUsedAgain) {
    const std::vector<Real> weights = {1, 5, 0, 2, 0.25};
    const DiscreteDistribution distribution(weights);
    constexpr int slots = 16;
    constexpr int samples = 400'000;
    std::vector<double> observed(weights.size() * slots, 0);
    std::vector<double> expected;
    for (std::size_t i = 0; i < weights.size(); ++i)
        expected.insert(expected.end(), slots, samples * distribution.probability(i) / slots);
    Random random(42, {});
    for (int i = 0; i < samples; ++i) {
        const auto [index, rest] = distribution.choose(random.uniform());
        ASSERT_GE(rest, 0);
        ASSERT_LT(rest, 1);
        ++observed[index * slots + static_cast<std::size_t>(rest * slots)];
    }
    EXPECT_GT(test::chiSquareProbability(observed, expected), 1e-6);
}

TEST(DiscreteDistribution, TakesWeightsOfAnySize) {
    for (const Real unit : {5e-324, 1e-320, 1e-300, 1.0, 1e300, 1.7e308}) {
        const DiscreteDistribution one(std::vector<Real>{unit});
        EXPECT_EQ(one.index(0), 0U);
        EXPECT_EQ(one.index(belowOne), 0U);
        EXPECT_EQ(one.probability(0), 1);
        EXPECT_EQ(one.sum(), unit);
        const DiscreteDistribution four(std::vector<Real>{unit, 0, unit, unit, unit});
        EXPECT_EQ(four.index(0.3), 2U) << unit;
        EXPECT_EQ(four.index(belowOne), 4U) << unit;
        EXPECT_DOUBLE_EQ(four.probability(3), 0.25) << unit;
        EXPECT_DOUBLE_EQ(four.choose(0.625).rest, 0.5) << unit;
    }
}

// Beside 1e300, 1e-300 is less than a rounding error. It is never chosen then, and says so.
TEST(DiscreteDistribution, IsHonestAboutWhatRoundingLeavesOut) {
    const DiscreteDistribution late(std::vector<Real>{1e300, 1e-300});
    EXPECT_EQ(late.index(belowOne), 0U);
    EXPECT_EQ(late.probability(0), 1);
    EXPECT_EQ(late.probability(1), 0);
    const DiscreteDistribution early(std::vector<Real>{1e-300, 1e300, 1e-300});
    EXPECT_EQ(early.index(0.5), 1U);
    EXPECT_EQ(early.probability(1), 1);
    for (const Real u : {0.0, 1e-300, 0.999, belowOne}) EXPECT_GT(early.probability(early.index(u)), 0) << u;
    const DiscreteDistribution ends(std::vector<Real>{0, 0, 2, 0, 0});
    for (const Real u : {0.0, 0.5, belowOne}) EXPECT_EQ(ends.index(u), 2U) << u;
}

TEST(DiscreteDistribution, RefusesWhatIsNoWeight) {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    EXPECT_THROW(DiscreteDistribution(std::vector<Real>{}), InputError);
    EXPECT_THROW(DiscreteDistribution(std::vector<Real>{0, 0}), InputError);
    EXPECT_THROW(DiscreteDistribution(std::vector<Real>{1, -1e-9}), InputError);
    EXPECT_THROW(DiscreteDistribution(std::vector<Real>{1, infinity}), InputError);
    EXPECT_THROW(DiscreteDistribution(std::vector<Real>{std::nan("")}), InputError);
}

}  // namespace
}  // namespace caustic
