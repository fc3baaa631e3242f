#pragma once

#include <optional>

namespace caustic::test {

/// The grader's own channel to a test program: two inherited descriptors.
///
/// What a program prints, the files that it leaves and its exit code are easily forged by the code under test. So the
/// grader (tools/exercises/testing.py) sends a random word through one pipe and believes only a verdict that comes with
/// that word through the other, written here when the test is over. docs/grading.md says what this cannot prevent.
struct VerdictChannel {
    int in = -1;   ///< the random word comes here, ended by a newline
    int out = -1;  ///< the verdict goes here: one line of JSON
};

/// Takes "--verdict=IN,OUT" off the command line.
/// @return nothing when it is not there: the program was started by a person or by ctest
std::optional<VerdictChannel> takeVerdictChannel(int& argc, char** argv);

/// Runs the one test that --gtest_filter selects (after InitGoogleTest) and sends the verdict: "passed", "failed",
/// "skipped", "not implemented" (a stub was reached), or "no such test" unless the filter selects exactly one.
/// @return the exit code: 0 when the test passed
int runForVerdict(const VerdictChannel& channel);

}  // namespace caustic::test
