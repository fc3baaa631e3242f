#include <gtest/gtest.h>

#include "failures/failure_cases.h"

namespace caustic {
namespace {

// What failure.csv counts, with another seed than the chart's.
TEST(Failures, RobustMethodsHaveNoneWhereOthersFail) {
    const auto rows = failureRows(1000, 77, 2);
    EXPECT_EQ(rows.size(), 20U);
    for (const FailureRow& row : rows) {
        EXPECT_GE(row.trials, 1000);
        if (row.robust) {
            EXPECT_EQ(row.failures, 0) << row.method << ": " << row.name;
        } else {
            EXPECT_GT(row.failures, row.trials / 2) << row.method << ": " << row.name << " is no test of anything";
        }
    }
}

}  // namespace
}  // namespace caustic
