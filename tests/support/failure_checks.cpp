#include "support/failure_checks.h"

#include <gtest/gtest.h>

namespace caustic::test {

void expectOnlyFragileMethodsFail(const std::vector<FailureRow>& rows, double least) {
    for (const FailureRow& row : rows) {
        EXPECT_GE(row.trials, 1000);
        if (row.robust) {
            EXPECT_EQ(row.failures, 0) << row.method << ": " << row.name;
        } else {
            EXPECT_GT(static_cast<double>(row.failures), least * static_cast<double>(row.trials))
                << row.method << ": " << row.name << " is no test of anything";
        }
    }
}

}  // namespace caustic::test
