#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "integrator/pixel_estimate.h"

namespace caustic {
namespace {

Color anyColor(Random& random) { return {random.uniform(), 5 * random.uniform(), 0.02 * random.uniform()}; }

// Two passes over all batches: the mean, then the squares about it, channel by channel.
TEST(PixelEstimate, HasTheMeanAndTheSquaresAboutIt) {
    Random random(1, {});
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Color> batches;
        PixelEstimate estimate;
        const auto count = 1 + random.below(30);
        for (std::uint64_t i = 0; i < count; ++i) {
            batches.push_back(anyColor(random));
            estimate.add(batches.back());
        }
        Color mean = Color::Zero();
        for (const Color& one : batches) mean += one / static_cast<Real>(count);
        Color squares = Color::Zero();
        for (const Color& one : batches) squares += (one - mean).square();
        ASSERT_EQ(estimate.batches, static_cast<std::int64_t>(count));
        ASSERT_LE(((estimate.mean - mean) / mean).abs().maxCoeff(), 1e-12) << "batches: " << count;
        // As large as the channel's values at most: a faint channel is as exact as a bright one.
        ASSERT_TRUE(((estimate.squares - squares).abs() <= 1e-12 * static_cast<Real>(count) * Color(1, 25, 4e-4)).all())
            << "One of the two distances is to the mean before, the other to the mean after.";
    }
}

// Noise of a hundred-millionth on a bright pixel: a sum of squares from which the squared mean is taken has no digit of
// it.
TEST(PixelEstimate, KeepsSmallNoiseOnLargeValues) {
    for (const Real scale : {1e-9, 1.0, 1e12}) {
        PixelEstimate estimate;
        for (int i = 0; i < 1000; ++i) estimate.add(scale * Color(1 + (i % 2 == 0 ? 1e-8 : -1e-8), 3, 1e3));
        EXPECT_NEAR(estimate.squares.x() / (scale * scale * 1e-13), 1, 0.02)
            << "scale " << scale << ": Is the noise the difference of two large sums?";
        EXPECT_LE(estimate.squares.y(), 1e-25 * scale * scale) << "What is constant has no noise.";
    }
}

Real normal(Random& random) {
    return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

// What those batches make of an estimate, by two passes over them.
PixelEstimate estimateOf(const std::vector<Color>& batches) {
    PixelEstimate estimate;
    estimate.batches = static_cast<std::int64_t>(batches.size());
    for (const Color& one : batches) estimate.mean += one / static_cast<Real>(batches.size());
    for (const Color& one : batches) estimate.squares += (one - estimate.mean).square();
    return estimate;
}

// As the name says: it holds the true mean in 95 % of all cases, however few the batches are.
TEST(ConfidenceInterval, HoldsTheTruthAsOftenAsItSays) {
    Random random(2, {});
    for (const int batches : {2, 3, 4, 6, 16, 100}) {
        constexpr int trials = 20'000;
        int held = 0;
        for (int trial = 0; trial < trials; ++trial) {
            std::vector<Color> values;
            for (int i = 0; i < batches; ++i) values.emplace_back(7 + 2 * normal(random), 1, 1);
            const PixelEstimate estimate = estimateOf(values);
            held += std::abs(estimate.mean.x() - 7) <= estimate.halfWidth(1.959964).x();
        }
        // Five standard errors of the share: 0.8 %.
        EXPECT_NEAR(held / static_cast<double>(trials), 0.95, 0.009)
            << batches << " batches: Is it the deviation of the mean, and is the variance known, or estimated?";
    }
}

// Each channel has its own; it goes with the values' scale; one batch says nothing.
TEST(ConfidenceInterval, IsOfEachChannelAndInItsUnit) {
    std::vector<Color> values;
    std::vector<Color> thousandfold;
    Random random(3, {});
    for (int i = 0; i < 9; ++i) {
        values.emplace_back(random.uniform(), 100 * random.uniform(), 3);
        thousandfold.push_back(1000 * values.back());
        if (i > 0) continue;
        EXPECT_TRUE((estimateOf(values).halfWidth(2) == std::numeric_limits<Real>::infinity()).all())
            << "How far apart are batches, when there is one?";
    }
    const PixelEstimate estimate = estimateOf(values);
    for (const Real deviations : {0.1, 0.5, 1.0, 2.0, 5.0}) {
        for (const std::int64_t batches : {0, 1}) {
            const Color none = PixelEstimate{batches, Color(2, 0, 7), Color::Zero()}.halfWidth(deviations);
            EXPECT_TRUE((none == std::numeric_limits<Real>::infinity()).all())
                << batches << " batches, " << deviations << " deviations: What is Student's t of no degree of freedom?";
        }
    }
    const Color width = estimate.halfWidth(2);
    EXPECT_GT(width.y(), 20 * width.x());
    EXPECT_LE(width.z(), 1e-12);
    EXPECT_NEAR(estimateOf(thousandfold).halfWidth(2).x() / width.x(), 1000, 1e-9);
    const PixelEstimate some = {9, Color(3, 0.2, 70), Color(0.013, 2.7e-5, 11)};
    const PixelEstimate brighter = {9, 1000 * some.mean, 1e6 * some.squares};
    const Color ratio = brighter.halfWidth(2) / some.halfWidth(2);
    EXPECT_LE((ratio / 1000 - 1).abs().maxCoeff(), 1e-13) << "In the values' unit, to the last digits?";
    EXPECT_GT(estimate.halfWidth(3).x(), 1.4 * width.x()) << "The surer, the wider.";
}

}  // namespace
}  // namespace caustic
