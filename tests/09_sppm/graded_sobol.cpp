#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "core/random.h"
#include "sampling/sobol.h"

namespace caustic {
namespace {

// Sobol's points as Joe and Kuo's program prints them, in 32nds: the first eight of six dimensions.
TEST(Sobol, IsTheKnownSequence) {
    // Of dimension 0 the bits of the index, mirrored; of dimension 1 Pascal's triangle modulo 2.
    const std::vector<std::vector<int>> known = {{0, 16, 8, 24, 4, 20, 12, 28}, {0, 16, 24, 8, 20, 4, 12, 28}};
    for (std::size_t d = 0; d < known.size(); ++d) {
        for (std::uint32_t i = 0; i < 8; ++i)
            EXPECT_EQ(sobolBits(i, static_cast<int>(d)) >> 27, static_cast<std::uint32_t>(known[d][i]))
                << "index " << i << ", dimension " << d << ": which direction numbers does a bit of the index call?";
    }
    for (int d = 0; d < sobolDimensions; ++d) {
        EXPECT_EQ(sobolBits(0, d), 0U);
        EXPECT_EQ(sobolBits(1, d), 0x80000000U) << "The first bit of the index is the first half.";
        // XOR of the index is XOR of the numbers: the sequence is linear over two elements.
        Random random(5, {static_cast<std::uint64_t>(d)});
        for (int trial = 0; trial < 1000; ++trial) {
            const auto a = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
            const auto b = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
            ASSERT_EQ(sobolBits(a ^ b, d), sobolBits(a, d) ^ sobolBits(b, d)) << "Does every bit of the index count?";
        }
    }
}

}  // namespace
}  // namespace caustic
