#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"

namespace caustic {
namespace {

std::vector<double> randomSums(int threads) {
    std::vector<double> sums(500);
    parallelFor(500, threads, [&](std::int64_t i) {
        Random random(7, {static_cast<std::uint64_t>(i)});
        double sum = 0;
        for (std::int64_t k = 0; k <= i; ++k) sum += random.uniform();
        sums[static_cast<std::size_t>(i)] = sum;
    });
    return sums;
}

TEST(ParallelFor, VisitsEachItemOnce) {
    for (const int threads : {1, 2, 3, 8}) {
        std::vector<std::atomic<int>> visits(1000);
        parallelFor(1000, threads, [&](std::int64_t i) { ++visits[static_cast<std::size_t>(i)]; });
        for (const auto& count : visits) EXPECT_EQ(count, 1);
    }
    parallelFor(0, 2, [](std::int64_t) { FAIL() << "no item was asked for"; });
}

// Bit for bit: an item's numbers and the order of its sum are its own.
TEST(ParallelFor, ResultsDoNotDependOnThreads) {
    const auto one = randomSums(1);
    for (const int threads : {2, 3, 7}) EXPECT_EQ(randomSums(threads), one) << threads << " threads";
}

// Which error the user reads must not depend on which thread was first.
TEST(ParallelFor, ThrowsTheLowestItemsException) {
    for (int repetition = 0; repetition < 50; ++repetition) {
        try {
            parallelFor(1000, 4, [](std::int64_t i) {
                if (i % 100 == 37) throw std::runtime_error(std::to_string(i));
            });
            FAIL() << "the exception was lost";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "37");
        }
    }
}

TEST(ParallelFor, ItemsBeforeAFailedOneAreStillDone) {
    std::vector<int> done(1000);
    EXPECT_THROW(parallelFor(1000, 2,
                             [&](std::int64_t i) {
                                 if (i == 700) throw std::runtime_error("700");
                                 done[static_cast<std::size_t>(i)] = 1;
                             }),
                 std::runtime_error);
    EXPECT_EQ(std::accumulate(done.begin(), done.begin() + 700, 0), 700);
}

constexpr int samples = 2'000'000;

// Chi-square statistic of 64 cells that should be equally full.
double chiSquare(const std::vector<int>& counts) {
    const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double expected = total / static_cast<double>(counts.size());
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}
// With 63 degrees of freedom chance passes this once in a million (Wilson and Hilferty's approximation: 131.7).
constexpr double limit = 132;

TEST(RandomNumbers, OfOneStreamAreUniform) {
    Random random(3, {1, 2});
    std::vector<int> counts(64);
    for (int i = 0; i < samples; ++i) {
        const double u = random.uniform();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        ++counts[static_cast<std::size_t>(u * 64)];
    }
    EXPECT_LT(chiSquare(counts), limit);
}

// Neighbouring items must not start alike: the pairs of first numbers of streams i and i + 1 fill the square evenly.
TEST(RandomNumbers, OfNeighbouringStreamsAreIndependent) {
    std::vector<int> counts(64);
    for (std::uint64_t item = 0; item < samples; ++item) {
        Random here(3, {item});
        Random next(3, {item + 1});
        const auto row = static_cast<std::size_t>(here.uniform() * 8);
        ++counts[row * 8 + static_cast<std::size_t>(next.uniform() * 8)];
    }
    EXPECT_LT(chiSquare(counts), limit);
}

// The power of the two tests above: numbers that fall into the first eighth 3 % too often are rejected.
TEST(RandomNumbers, ThreePercentTooManyInAnOctantWouldBeSeen) {
    Random random(3, {4});
    std::vector<int> counts(64);
    for (int i = 0; i < samples; ++i) {
        const bool moved = random.uniform() < 0.03 / 8;
        ++counts[random.below(moved ? 8 : 64)];
    }
    EXPECT_GT(chiSquare(counts), limit);
}

TEST(RandomNumbers, StreamsAreNamedBySeedAndAllIndices) {
    std::set<double> first;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        for (std::uint64_t i = 0; i < 10; ++i) {
            for (std::uint64_t k = 0; k < 10; ++k) first.insert(Random(seed, {i, k}).uniform());
        }
    }
    EXPECT_EQ(first.size(), 1000U) << "Two names gave the same stream.";
    EXPECT_NE(Random(1, {2, 3}).uniform(), Random(1, {3, 2}).uniform()) << "The order of the indices counts.";
    EXPECT_NE(Random(1, {2}).uniform(), Random(1, {2, 0}).uniform()) << "So does their number.";
    EXPECT_EQ(Random(1, {2, 3}).uniform(), Random(1, {2, 3}).uniform());
}

TEST(RandomNumbers, BelowReachesEachNumberAndNoOther) {
    Random random(5, {});
    std::vector<int> counts(7);
    for (int i = 0; i < 7000; ++i) ++counts.at(random.below(7));
    for (const int count : counts) EXPECT_NEAR(count, 1000, 6 * std::sqrt(1000.0));
    EXPECT_EQ(random.below(1), 0U);
}

TEST(RandomNumbers, RangeIsHalfOpen) {
    Random random(6, {});
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform(-3, 5);
        EXPECT_GE(x, -3);
        EXPECT_LT(x, 5);
    }
}

}  // namespace
}  // namespace caustic
