#include <gtest/gtest.h>

#include "expect_brute_force.h"

namespace caustic::test {
namespace {

// A million queries, ties aside: every kind of cloud, three sizes.
TEST(LargePointKdTree, FindsWhatBruteForceFinds) {
    for (const std::size_t n : {50, 500, 2500}) {
        for (const PointCloud& cloud : pointClouds(n, 11)) expectBruteForce(cloud, 47'620, 12);
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace caustic::test
