#pragma once

#include <optional>

namespace caustic::test {

/// The grader's own channel to a test program: two inherited descriptors.
///
/// What a program prints, the files that it leaves and its exit code are easily forged by the code under test. So, when
/// the test is over, the program asks the grader (tools/exercises/verdicts.py) for a random word, and only a verdict
/// that comes with that word is believed. docs/grading.md says what this cannot prevent.
struct VerdictChannel {
    int in = -1;   ///< the random word comes here, ended by a newline
    int out = -1;  ///< here go the line "over", which asks for the word, and the verdict: one line of JSON
};

/// Takes "--verdict=IN,OUT" off the command line.
/// @return nothing when it is not there: the program was started by a person or by ctest
std::optional<VerdictChannel> takeVerdictChannel(int& argc, char** argv);

/// Runs the one test that --gtest_filter selects (after InitGoogleTest) and sends the verdict: "passed", "failed",
/// "skipped", "not implemented" (a stub was reached), or "no such test" unless the filter selects exactly one.
/// @return the exit code: 0 when the test passed
int runForVerdict(const VerdictChannel& channel);

}  // namespace caustic::test
