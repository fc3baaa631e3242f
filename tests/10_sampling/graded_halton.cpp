#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/random.h"
#include "math/vector.h"
#include "sampling/halton.h"
#include "support/chi_square.h"

namespace caustic {
namespace {

constexpr double falseAlarm = 1e-6;
constexpr std::uint32_t primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};

std::uint64_t anyKey(Random& random) { return random.below(std::uint64_t{1} << 63); }

// Halton 1960: each run of b^m points that starts at a multiple of b^m has one in each of b^m equal intervals; permuted
// digits leave that as it is.
TEST(Halton, PutsOnePointIntoEachInterval) {
    Random random(1, {});
    for (int dimension = 0; dimension < haltonDimensions; ++dimension) {
        const std::uint32_t base = primes[dimension];
        for (std::uint32_t run = base; run <= 3000; run *= base) {
            const std::uint64_t key = anyKey(random);
            const auto start = static_cast<std::uint32_t>(random.below(200)) * run;
            std::set<std::uint32_t> intervals;
            for (std::uint32_t i = 0; i < run; ++i) {
                const Real u = haltonNumber(start + i, dimension, key);
                ASSERT_TRUE(u >= 0 && u < 1) << u;
                intervals.insert(static_cast<std::uint32_t>(u * run));
            }
            ASSERT_EQ(intervals.size(), run) << "dimension " << dimension << ", points " << start << " to "
                                             << start + run - 1 << ": Does the index's last digit count most?";
        }
    }
}

// Index 0 has zeros without end, and each of them is permuted: its first four digits are uniform together, and they
// don't hang together with those of another dimension of the same key.
TEST(Halton, PermutesEachDigitByItself) {
    Random random(2, {});
    for (const int dimension : {0, 1, 2}) {
        const std::uint32_t base = primes[dimension];
        const std::uint32_t cells = base * base * base * (dimension == 2 ? 1 : base);
        std::vector<double> counts(cells, 0);
        constexpr int trials = 40'000;
        for (int i = 0; i < trials; ++i)
            ++counts[static_cast<std::size_t>(haltonNumber(0, dimension, anyKey(random)) * cells)];
        EXPECT_GT(test::chiSquareProbability(counts, std::vector<double>(cells, trials / static_cast<double>(cells))),
                  falseAlarm)
            << "base " << base << ": Are leading zeros permuted, each place by a permutation of its own?";
    }

    // 200 of 29⁷ numbers: two of them are the same once in 10⁶, three pairs never.
    for (const int shift : {0, 32}) {
        std::set<Real> numbers;
        for (std::uint64_t k = 0; k < 200; ++k) numbers.insert(haltonNumber(0, 9, 0x2b00000017 + (k << shift)));
        EXPECT_GE(numbers.size(), 198U) << "Does each of a key's 64 bits name other permutations?";
    }

    // Multiples of the largest b⁻ᵏ that is at most 2⁻³², and all of these: the last digit takes each value.
    for (int dimension = 0; dimension < haltonDimensions; ++dimension) {
        const std::uint64_t base = primes[dimension];
        std::uint64_t steps = 1;
        while (steps < std::uint64_t{1} << 32) steps *= base;
        std::set<std::uint64_t> last;
        for (int i = 0; i < 1000; ++i) {
            const auto index = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
            const Real scaled = haltonNumber(index, dimension, anyKey(random)) * static_cast<Real>(steps);
            ASSERT_NEAR(scaled, std::round(scaled), 1e-4) << "base " << base << ": How many digits has a number?";
            last.insert(static_cast<std::uint64_t>(std::round(scaled)) % base);
        }
        EXPECT_EQ(last.size(), base) << "base " << base << ": How many digits has a number?";
    }
}

// Points 0 ... 22 of bases 23 and 29 climb side by side when digits aren't permuted, and go round when a number is only
// added to each. Permuted at random their order is any: the square of their correlation is 1/22 in the mean.
TEST(Halton, PartsDimensionsOfLargeBases) {
    Random random(3, {});
    Real sum = 0;
    constexpr int keys = 1000;
    constexpr std::uint32_t points = 23;
    for (int k = 0; k < keys; ++k) {
        const std::uint64_t first = anyKey(random);
        const std::uint64_t second = anyKey(random);
        Vec2 mean = Vec2::Zero();
        std::vector<Vec2> all;
        for (std::uint32_t i = 0; i < points; ++i) {
            all.emplace_back(haltonNumber(i, 8, first), haltonNumber(i, 9, second));
            mean += all.back() / points;
        }
        Real xx = 0;
        Real yy = 0;
        Real xy = 0;
        for (const Vec2& one : all) {
            const Vec2 off = one - mean;
            xx += off.x() * off.x();
            yy += off.y() * off.y();
            xy += off.x() * off.y();
        }
        sum += xy * xy / (xx * yy) / keys;
    }
    EXPECT_LT(sum, 0.12) << "Is the order of the digits any of all orders?";
}

}  // namespace
}  // namespace caustic
