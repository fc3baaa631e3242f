#include <gtest/gtest.h>

#include "expect_nothing_missed.h"

namespace caustic {
namespace {

constexpr int threads = 2;
constexpr std::uint64_t seed = 2;
constexpr std::size_t tangents = 6;

class LargePatchRoots : public testing::TestWithParam<std::size_t> {};

// Ten thousand rays of each adversarial set. Near a fold two meetings lie close together, and not every pair is told
// apart: the lesson says so.
TEST_P(LargePatchRoots, LosesNothing) {
    const RootExamination count = examinePatches(GetParam(), 10'000, seed, threads);
    if (GetParam() != tangents) return test::expectNothingMissed(count, patchSetNames()[GetParam()]);
    EXPECT_LE(count.misses, count.meetings / 100) << "of " << count.meetings;
    EXPECT_EQ(count.falseHits, 0);
    EXPECT_LE(count.worstDistance, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(EverySet, LargePatchRoots, testing::Range(std::size_t{1}, patchSetNames().size()));

}  // namespace
}  // namespace caustic
