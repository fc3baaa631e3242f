#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "sampling/independent_sampler.h"
#include "sampling/sobol.h"
#include "sampling/sobol_sampler.h"
#include "support/chi_square.h"

namespace caustic {
namespace {

// Each of the 2^m intervals of each run of 2^m points holds one, scrambled or not.
TEST(SobolBits, EveryRunIsEvenInEachDimension) {
    for (const std::uint32_t seed : {0U, 1U, 0xdeadbeefU}) {
        for (int d = 0; d < sobolDimensions; ++d) {
            for (const std::uint32_t m : {1U, 4U, 10U}) {
                for (const std::uint32_t run : {0U, 3U, 1000U}) {
                    std::vector<int> hits(std::size_t{1} << m, 0);
                    for (std::uint32_t i = 0; i < 1U << m; ++i) {
                        const std::uint32_t bits = sobolBits((run << m) + i, d);
                        ++hits[(seed == 0 ? bits : owenScrambled(bits, seed)) >> (32 - m)];
                    }
                    for (const int count : hits) ASSERT_EQ(count, 1) << "dimension " << d << ", run " << run;
                }
            }
        }
    }
}

// Dimensions 0 and 1: every box of area 2^-m whose sides are powers of two holds one of each run of 2^m points.
TEST(SobolBits, TheFirstPairIsEvenInEveryBox) {
    constexpr std::uint32_t m = 8;
    for (const std::uint32_t run : {0U, 5U}) {
        for (std::uint32_t wide = 0; wide <= m; ++wide) {
            std::vector<int> hits(std::size_t{1} << m, 0);
            for (std::uint32_t i = 0; i < 1U << m; ++i) {
                const std::uint64_t x = owenScrambled(sobolBits((run << m) + i, 0), 77);
                const std::uint64_t y = owenScrambled(sobolBits((run << m) + i, 1), 99);
                ++hits[(x >> (32 - wide)) << (m - wide) | y >> (32 - (m - wide))];
            }
            for (const int count : hits) ASSERT_EQ(count, 1) << "boxes of width 2^-" << wide;
        }
    }
}

// Nested: numbers that share their first k bits share exactly those afterwards.
TEST(OwenScrambled, KeepsWhatIsShared) {
    Random random(3, {1});
    for (int trial = 0; trial < 100'000; ++trial) {
        const auto a = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
        const auto b = a ^ (static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32)) >> random.below(32));
        const auto seed = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
        const std::uint32_t before = a ^ b;
        const std::uint32_t after = owenScrambled(a, seed) ^ owenScrambled(b, seed);
        ASSERT_EQ(std::countl_zero(before), std::countl_zero(after)) << a << " " << b << " " << seed;
    }
}

// Over seeds, each number is uniform and each pair of dimensions independent.
TEST(OwenScrambled, IsUniformOverSeeds) {
    constexpr int cells = 16;
    for (const std::uint32_t index : {0U, 1U, 12345U}) {
        std::vector<double> counts(cells * cells, 0);
        constexpr int trials = 200'000;
        Random random(9, {index});
        for (int trial = 0; trial < trials; ++trial) {
            const auto one = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
            const auto other = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
            const std::uint32_t x = owenScrambled(sobolBits(index, 2), one) >> 28;
            const std::uint32_t y = owenScrambled(sobolBits(index, 3), other) >> 28;
            ++counts[x * cells + y];
        }
        double chi = 0;
        const double expected = double{trials} / (cells * cells);
        for (const double count : counts) chi += (count - expected) * (count - expected) / expected;
        // 255 degrees of freedom: mean 255, deviation 22.6; six of them.
        EXPECT_LT(chi, 255 + 6 * 22.6);
    }
}

// What the sampler gives a pixel's first 64 paths: each pair that matters one in each cell of an 8 × 8 grid (the first
// pair and the light's point), each single choice one in each 64th.
TEST(SobolSampler, SpreadsAPixelsPaths) {
    const SobolSampler sampler(41);
    for (const Pixel pixel : {Pixel{0, 0}, Pixel{17, 3}, Pixel{400, 299}}) {
        for (const std::int64_t start : {std::int64_t{0}, std::int64_t{64}, std::int64_t{1} << 33}) {
            for (const Dimension pair : {Dimension::film(), Dimension::vertex(0, VertexUse::LightPoint)}) {
                std::vector<int> hits(64, 0);
                for (int i = 0; i < 64; ++i) {
                    const Vec2 u = sampler.start(0, pixel, start + i).pair(pair);
                    ++hits[static_cast<std::size_t>(u.x() * 8) * 8 + static_cast<std::size_t>(u.y() * 8)];
                }
                for (const int count : hits) ASSERT_EQ(count, 1);
            }
            for (const VertexUse use : {VertexUse::LightChoice, VertexUse::Lobe}) {
                std::vector<int> hits(64, 0);
                for (int i = 0; i < 64; ++i)
                    ++hits[static_cast<std::size_t>(
                        sampler.start(0, pixel, start + i).number(Dimension::vertex(0, use)) * 64)];
                for (const int count : hits) ASSERT_EQ(count, 1);
            }
        }
    }
}

// Numbers beyond the first vertex are plain random ones, and all are in [0, 1).
TEST(SobolSampler, IsRandomBeyondTheFirstVertex) {
    const SobolSampler sampler(7);
    Real sum = 0;
    for (int i = 0; i < 10'000; ++i) {
        const PathNumbers numbers = sampler.start(1, {0, 0}, i);
        for (int dimension = 0; dimension < 60; ++dimension) {
            const Vec2 u = numbers.pair({dimension});
            ASSERT_TRUE(u.minCoeff() >= 0 && u.maxCoeff() < 1);
        }
        sum += numbers.number(Dimension::vertex(3, VertexUse::Direction));
    }
    EXPECT_NEAR(sum / 10'000, 0.5, 5 * std::sqrt(1.0 / 12 / 10'000));
}

// The error of a smooth integral over the first two pairs, of 4,096 points: a tenth of plain random numbers' at most.
TEST(SobolSampler, IntegratesSmoothFunctionsBetter) {
    const auto squaredError = [](const Sampler& sampler) {
        Real squares = 0;
        for (int pixel = 0; pixel < 32; ++pixel) {
            Real sum = 0;
            for (int i = 0; i < 4096; ++i) {
                const PathNumbers numbers = sampler.start(1, {pixel, 0}, i);
                const Vec2 a = numbers.pair(Dimension::film());
                const Vec2 b = numbers.pair(Dimension::lens());
                sum += a.x() * a.y() * std::exp(b.x()) * std::cos(b.y());
            }
            const Real exact = 0.25 * (std::exp(1.0) - 1) * std::sin(1.0);
            squares += (sum / 4096 - exact) * (sum / 4096 - exact);
        }
        return squares;
    };
    EXPECT_LT(squaredError(SobolSampler(1)), 0.01 * squaredError(IndependentSampler(1)));
}

}  // namespace
}  // namespace caustic
