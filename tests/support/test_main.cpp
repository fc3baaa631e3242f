#include <gtest/gtest.h>

#include "support/verdict.h"

// The main function of every test program: all tests for a person or for ctest, one test with a verdict for the grader.
int main(int argc, char** argv) {
    const auto channel = caustic::test::takeVerdictChannel(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return channel ? caustic::test::runForVerdict(*channel) : RUN_ALL_TESTS();
}
