#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "figures.h"
#include "support/failure_checks.h"

namespace caustic {
namespace {

// What failure.csv counts, with another seed than the chart's.
TEST(Failures, RobustMethodsSurviveAllAndFragileOnesBreak) {
    test::expectOnlyFragileMethodsFail(failureRows({2000, 77, 2}), 0.02);
}

TEST(FailureTable, HasAFragileAndARobustMethodForEachKindOfCase) {
    std::set<std::string> fragile;
    std::set<std::string> robust;
    for (const FailureRow& row : failureRows({1, 77})) (row.robust ? robust : fragile).insert(row.name);
    EXPECT_EQ(fragile, robust);
    EXPECT_GE(robust.size(), 5U);
}

TEST(FailureTable, CountsDoNotDependOnThreads) {
    const auto one = failureRows({200, 77, 1});
    const auto two = failureRows({200, 77, 2});
    EXPECT_TRUE(std::ranges::equal(one, two, {}, &FailureRow::failures, &FailureRow::failures));
}

// A right answer on the tolerance's border counts, NaN never does.
TEST(FailureTable, JudgesAnswers) {
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(within(0.5, 2, {2.5, 1.5, 2.6, notANumber}), (std::vector<bool>{true, true, false, false}));
}

}  // namespace
}  // namespace caustic
