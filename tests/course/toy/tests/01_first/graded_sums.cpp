#include <gtest/gtest.h>

#include "math/clamp.h"
#include "math/sums.h"

namespace caustic {
namespace {

TEST(Sums, TotalAddsAllValues) {
    EXPECT_EQ(total({1, -2, 4}), 3) << "Does every value count, whatever its sign?";
    EXPECT_EQ(total({}), 0);
}

TEST(Sums, LargestIsTheLargest) { EXPECT_EQ(largest({-3, -1, -2}), -1) << "What does the search start with?"; }

TEST(Sums, MeanIsTotalOverCount) { EXPECT_EQ(mean({1, 2, 6}), 3) << "By how many values is the sum divided?"; }

TEST(Clamp, StaysWithinBounds) {
    EXPECT_EQ(clampTo(5, 1, 3), 3) << "Which end is the value beyond?";
    EXPECT_EQ(clampTo(0, 1, 3), 1) << "Which end is the value beyond?";
    EXPECT_EQ(clampTo(2, 1, 3), 2);
    for (int n = 0; n < 50; ++n) EXPECT_EQ(clampTo(-n, 1, 3), 1);
}

}  // namespace
}  // namespace caustic
