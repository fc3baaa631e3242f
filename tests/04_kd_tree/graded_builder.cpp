#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "accel/kd_build.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;
using Box = KdBox<Real>;
using Event = KdEvent<Real>;

std::vector<Box> randomBoxes(std::uint64_t seed, int count, Real flatShare) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Vec3 corner = inCube(random);
        Vec3 size = 0.3 * (inCube(random) + Vec3::Ones());
        if (random.uniform() < flatShare) size.x() = 0;
        boxes.emplace_back(corner, corner + size);
    }
    return boxes;
}

std::vector<Event> eventsOf(const std::vector<Box>& boxes, int axis) {
    std::vector<Event> events;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Real low = boxes[i].min()[axis];
        const Real high = boxes[i].max()[axis];
        if (low == high) {
            events.emplace_back(low, i, Event::Flat);
        } else {
            events.emplace_back(low, i, Event::Start);
            events.emplace_back(high, i, Event::End);
        }
    }
    std::sort(events.begin(), events.end());
    return events;
}

// A box of 2 x 1 x 1 has the surface 10, its halves 6 each: 1 + 6/10 (3 + 5) tests of cost 2.
TEST(SplitCost, IsOneStepAndTheItemsByTheChanceToMeetTheirSide) {
    const Box box(Vec3::Zero(), Vec3(2, 1, 1));
    KdRule rule;
    rule.stepCost = 1;
    rule.itemCost = 2;
    EXPECT_NEAR(splitCost<Real>(box, 0, 1.0, 3, 5, rule), 1 + 2 * 0.6 * (3 + 5), 1e-12)
        << "Is a side's chance the ratio of its surface to the box's, and does each item cost itemCost?";
    // Across y: 0.25 of the height leaves a surface of 2 (2 + 0.25 + 0.5) = 5.5, the rest one of 8.5.
    EXPECT_NEAR(splitCost<Real>(box, 1, 0.25, 4, 7, rule), 1 + 2 * (0.55 * 4 + 0.85 * 7), 1e-12)
        << "Which axis is cut?";
}

// Leaves of eight are tested at once: 9 items cost as much as 16.
TEST(SplitCost, CountsWholeBlocksAndForgivesEmptySides) {
    const Box box(Vec3::Zero(), Vec3(2, 1, 1));
    KdRule rule;
    rule.block = 8;
    rule.emptyBonus = 0.2;
    EXPECT_NEAR(splitCost<Real>(box, 0, 1.0, 9, 8, rule), splitCost<Real>(box, 0, 1.0, 16, 1, rule), 1e-12)
        << "Is leafCost used, which counts blocks?";
    EXPECT_NEAR(splitCost<Real>(box, 0, 1.0, 0, 8, rule), 0.8 * (1 + 0.6 * rule.itemCost), 1e-12)
        << "Is the whole cost forgiven by emptyBonus when a side is empty?";
    EXPECT_NEAR(splitCost<Real>(box, 0, 1.0, 8, 0, rule), 0.8 * (1 + 0.6 * rule.itemCost), 1e-12)
        << "And when it is the other side?";
}

// By definition: every place where a box begins or ends is tried, the boxes on each side are counted one by one.
TEST(SweepPlanes, FindsWhatTryingEveryPlaneFinds) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const std::vector<Box> boxes = randomBoxes(seed, 2 + static_cast<int>(seed % 30), 0.3);
        Box all;
        for (const Box& box : boxes) all.extend(box);
        const KdRule rule;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            Real cheapest = 1e30;
            for (const Event& event : eventsOf(boxes, static_cast<int>(axis))) {
                if (event.at <= all.min()[axis] || event.at >= all.max()[axis]) continue;
                std::uint32_t below = 0;
                std::uint32_t above = 0;
                std::uint32_t flat = 0;
                for (const Box& box : boxes) {
                    const bool isFlat = box.min()[axis] == event.at && box.max()[axis] == event.at;
                    flat += isFlat ? 1U : 0U;
                    below += !isFlat && box.min()[axis] < event.at ? 1U : 0U;
                    above += !isFlat && box.max()[axis] > event.at ? 1U : 0U;
                }
                cheapest = std::min({cheapest, splitCost<Real>(all, axis, event.at, below + flat, above, rule),
                                     splitCost<Real>(all, axis, event.at, below, above + flat, rule)});
            }
            KdPlane<Real> best;
            best.cost = 1e30;
            const auto events = eventsOf(boxes, static_cast<int>(axis));
            sweepPlanes<Real>(events, all, axis, static_cast<std::uint32_t>(boxes.size()), rule, best);
            ASSERT_NEAR(best.cost, cheapest, 1e-9 * cheapest)
                << "seed " << seed << ", axis " << axis
                << ": at one place, what ends goes out before the plane is judged, what starts comes in after; do flat "
                   "boxes count on one side only?";
            if (cheapest < 1e30) {
                EXPECT_EQ(best.axis, axis) << "Is the axis stored with the plane?";
            }
        }
    }
}

// A plane in a face of the box cuts nothing off, and one that costs more than the best so far is not better.
TEST(SweepPlanes, KeepsABetterPlaneAndStaysWithinTheBox) {
    const std::vector<Box> boxes = randomBoxes(1, 20, 0);
    Box all;
    for (const Box& box : boxes) all.extend(box);
    KdPlane<Real> best;
    best.cost = 1e-3;
    best.at = 42;
    sweepPlanes<Real>(eventsOf(boxes, 0), all, 0, 20, KdRule{}, best);
    EXPECT_EQ(best.at, 42) << "Is the best plane replaced by a worse one?";

    // All boxes fill the whole: events at the faces alone.
    const std::vector<Box> same(5, Box(Vec3::Zero(), Vec3::Ones()));
    best.cost = 1e30;
    sweepPlanes<Real>(eventsOf(same, 1), same[0], 1, 5, KdRule{}, best);
    EXPECT_EQ(best.cost, 1e30) << "Is a plane in a face of the box taken, which splits nothing?";
}

}  // namespace
}  // namespace caustic
