#include <gtest/gtest.h>

#include <string>

#include "figure/timing.h"

namespace caustic {
namespace {

// A machine slows down in the middle of a run: only what takes turns is slowed down alike.
TEST(Timing, PiecesTakeTurnsRoundByRound) {
    std::string order;
    const std::vector<std::function<void()>> pieces = {[&] { order += 'a'; }, [&] { order += 'b'; }};
    const auto nanoseconds = medianNanoseconds(pieces, {3, 0});
    EXPECT_EQ(order,
              "ab"
              "ababab")
        << "One call each to find how many a batch needs, then the rounds.";
    EXPECT_EQ(nanoseconds.size(), 2U);
}

TEST(Timing, BatchesAreAsLongAsAsked) {
    int calls = 0;
    const auto nanoseconds = medianNanoseconds({[&] { keep(++calls); }}, {1, 1e-4});
    EXPECT_GT(calls, 1000) << "A call this short must be repeated until a batch can be measured.";
    EXPECT_GT(nanoseconds.front(), 0);
}

TEST(Timing, NothingToTimeIsNoError) { EXPECT_TRUE(medianNanoseconds({}, {}).empty()); }

}  // namespace
}  // namespace caustic
