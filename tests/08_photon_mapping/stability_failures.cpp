#include <gtest/gtest.h>

#include "figures.h"
#include "support/failure_checks.h"

namespace caustic {
namespace {

// What failure.csv counts, with another seed than the chart's.
TEST(Failures, RobustMethodsHaveNoneWhereOthersFail) {
    const auto rows = failureRows({1000, 77, 2});
    EXPECT_EQ(rows.size(), 22U);
    test::expectOnlyFragileMethodsFail(rows, 0.5);
}

}  // namespace
}  // namespace caustic
