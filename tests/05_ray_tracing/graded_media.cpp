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
    EXPECT_EQ(intoDrink.before.ior(), 1.5) << "Is the side that it comes from as it was?";
    EXPECT_FALSE(intoDrink.before.contains(1));
    const Crossing outOfGlass = crossBoundary(intoDrink.after, 0, glass, false);
    EXPECT_FALSE(outOfGlass.counts());
    EXPECT_TRUE(outOfGlass.before.contains(0) && outOfGlass.before.contains(1));
    EXPECT_FALSE(outOfGlass.after.contains(0)) << "What does the path leave?";
    EXPECT_TRUE(outOfGlass.after.contains(1)) << "What is the path still in?";
    const Crossing outOfDrink = crossBoundary(outOfGlass.after, 1, drink, false);
    EXPECT_EQ(outOfDrink.before.ior(), 1.33);
    EXPECT_EQ(outOfDrink.after.object(), noObject) << "Is anything left of what the path has been in?";

    // A surface that overlaps itself: what is entered twice is left twice.
    const MediumStack twice = crossBoundary(inGlass, 0, glass, true).after;
    const MediumStack once = crossBoundary(twice, 0, glass, false).after;
    EXPECT_TRUE(once.contains(0)) << "How often has the path entered, and how often left?";
    EXPECT_FALSE(crossBoundary(once, 0, glass, false).after.contains(0));
}

// A path that starts in an object leaves it without having entered.
TEST(Media, LeavingWhatWasNeverEnteredMeansHavingBeenInIt) {
    const Crossing out = crossBoundary({}, 0, glass, false);
    EXPECT_EQ(out.before.ior(), 1.5) << "Where must the path have started?";
    EXPECT_EQ(out.after.ior(), 1);
    EXPECT_TRUE(out.counts());
    EXPECT_FALSE(out.after.contains(0));

    // In the drink, of which it knows, out of the glass, of which it doesn't.
    const MediumStack inDrink = crossBoundary({}, 1, drink, true).after;
    const Crossing hidden = crossBoundary(inDrink, 0, glass, false);
    EXPECT_TRUE(hidden.before.contains(0)) << "Where must the path have started?";
    EXPECT_TRUE(hidden.before.contains(1)) << "What did the path know already?";
    EXPECT_FALSE(hidden.after.contains(0));
    EXPECT_EQ(hidden.after.ior(), 1.33);
    EXPECT_FALSE(hidden.counts());
}

}  // namespace
}  // namespace caustic
