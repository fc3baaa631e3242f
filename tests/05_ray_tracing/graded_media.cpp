#include <gtest/gtest.h>

#include "medium/medium_stack.h"

namespace caustic {
namespace {

const Interior glass = {1.5, nullptr, 0};
const Interior drink = {1.33, nullptr, 1};

// Into the glass, into the drink that reaches into it, out of the glass: that boundary is hidden in the drink.
TEST(Media, ABoundaryInsideSomethingOfHigherPriorityDoesNotCount) {
    const MediumStack inGlass = crossBoundary({}, 0, glass, true).after;
    const Crossing intoDrink = crossBoundary(inGlass, 1, drink, true);
    EXPECT_TRUE(intoDrink.counts());
    EXPECT_EQ(intoDrink.after.ior(), 1.33);
    EXPECT_TRUE(intoDrink.after.contains(0)) << "Is the glass forgotten, though the path is still in it?";
    EXPECT_FALSE(crossBoundary(intoDrink.after, 0, glass, false).counts());
}

// A path that starts in an object leaves it without having entered.
TEST(Media, LeavingWhatWasNeverEnteredMeansHavingBeenInIt) {
    const Crossing out = crossBoundary({}, 0, glass, false);
    EXPECT_EQ(out.before.ior(), 1.5) << "Where must the path have started?";
    EXPECT_EQ(out.after.ior(), 1);
    EXPECT_TRUE(out.counts());
}

}  // namespace
}  // namespace caustic
