#include <gtest/gtest.h>

#include <set>

#include "failures/failure_cases.h"

namespace caustic {
namespace {

constexpr std::uint64_t seed = 77;

class Failures : public testing::TestWithParam<FailureProbe> {};

// The lesson's promise, on other cases than its chart's: the robust survive all, the fragile are seen to break.
TEST_P(Failures, RobustMethodSurvivesAllAndFragileOneBreaks) {
    const FailureProbe probe = GetParam();
    const int failures = countFailures(probe, seed, 2);
    if (probe.robust) {
        EXPECT_EQ(failures, 0) << probe.method << " must survive: " << probe.name;
    } else {
        EXPECT_GT(failures, failureTrials / 50) << probe.method << " is shown to break on: " << probe.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Chart, Failures, testing::ValuesIn(failureProbes()), [](const auto& description) {
    std::string name = description.param.method + "_" + std::to_string(description.index);
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name;
});

TEST(FailureTable, HasAFragileAndARobustMethodForEachKindOfCase) {
    std::set<std::string> fragile;
    std::set<std::string> robust;
    for (const FailureProbe& probe : failureProbes()) (probe.robust ? robust : fragile).insert(probe.name);
    EXPECT_EQ(fragile, robust);
    EXPECT_GE(robust.size(), 5U);
    EXPECT_GE(failureTrials, 1000);
}

TEST(FailureTable, CountsDoNotDependOnThreads) {
    const FailureProbe fragile = failureProbes().front();
    EXPECT_EQ(countFailures(fragile, seed, 1), countFailures(fragile, seed, 2));
}

}  // namespace
}  // namespace caustic
