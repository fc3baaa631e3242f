#include <gtest/gtest.h>

#include "expect_nothing_missed.h"

namespace caustic {
namespace {

constexpr int threads = 2;
constexpr std::uint64_t seed = 2;

class LargePatchRoots : public testing::TestWithParam<std::size_t> {};

// Ten thousand rays of each adversarial set.
TEST_P(LargePatchRoots, LosesNothing) {
    test::expectNothingMissed(examinePatches(GetParam(), 10'000, seed, threads), patchSetNames()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(EverySet, LargePatchRoots, testing::Range(std::size_t{1}, patchSetNames().size()));

}  // namespace
}  // namespace caustic
