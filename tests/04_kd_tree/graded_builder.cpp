#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "accel/kd_build.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;
using Box = KdBox<Real>;
using Event = KdEvent<Real>;

// Boxes of coordinates that come again and again, so that many begin and end at one place; some are flat. All of them
// lie far from the origin, in a space that is longer than wide.
std::vector<Box> randomBoxes(std::uint64_t seed, int count, Real flatShare, Real scale = 1) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        Vec3 corner;
        Vec3 size;
        for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = static_cast<Real>(random.below(12)) / 8;
            size[axis] = random.uniform() < flatShare ? 0 : static_cast<Real>(1 + random.below(4)) / 8;
        }
        const Vec3 stretch = scale * Vec3(1, 4, 0.5);
        const Vec3 far = scale * Vec3(64.1, -32.3, 16.7);  // no float
        boxes.emplace_back(far + stretch.cwiseProduct(corner), far + stretch.cwiseProduct(corner + size));
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

// Half a box's surface.
Real halfSurface(const Vec3& d) { return d.x() * d.y() + d.y() * d.z() + d.z() * d.x(); }

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
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random(5, {i});
        const Real scale = std::pow(10, random.uniform(-6, 6));
        const Vec3 size = scale * Vec3(random.uniform(0.1, 1), random.uniform(1, 2), random.uniform(2, 4));
        const Vec3 corner = 3 * scale * inCube(random);
        const std::uint32_t axis = static_cast<std::uint32_t>(random.below(3));
        const Real share = random.uniform(0.1, 0.9);
        const auto below = static_cast<std::uint32_t>(1 + random.below(50));
        const auto above = static_cast<std::uint32_t>(1 + random.below(50));
        rule.stepCost = random.uniform(0, 5);
        rule.itemCost = random.uniform(0.5, 3);
        Vec3 lower = size;
        Vec3 upper = size;
        lower[axis] *= share;
        upper[axis] *= 1 - share;
        const Real expected = rule.stepCost + rule.itemCost *
                                                  (halfSurface(lower) * below + halfSurface(upper) * above) /
                                                  halfSurface(size);
        const Real found =
            splitCost<Real>(Box(corner, corner + size), axis, corner[axis] + share * size[axis], below, above, rule);
        ASSERT_NEAR(found, expected, 1e-11 * expected)
            << "Box " << i << ", cut across axis " << axis << ": is the plane at its place, not at the origin's?";
    }
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
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Real scale = std::array<Real, 3>{1, 0x1p-20, 0x1p20}[seed % 3];
        const std::vector<Box> boxes = randomBoxes(seed, 2 + static_cast<int>(seed % 30), 0.3, scale);
        Box all;
        for (const Box& box : boxes) all.extend(box);
        // A cell may have room beside its boxes, where a plane cuts nothing but empty space off.
        if (seed % 2 == 1) all = {all.min() - scale * Vec3(0.3, 0.2, 0.1), all.max() + scale * Vec3(0.1, 0.4, 0.3)};
        const KdRule rule;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const auto costAt = [&](Real at, bool flatBelow) {
                std::uint32_t below = 0;
                std::uint32_t above = 0;
                for (const Box& box : boxes) {
                    const bool isFlat = box.min()[axis] == at && box.max()[axis] == at;
                    below += (isFlat ? flatBelow : box.min()[axis] < at) ? 1U : 0U;
                    above += (isFlat ? !flatBelow : box.max()[axis] > at) ? 1U : 0U;
                }
                return splitCost<Real>(all, axis, at, below, above, rule);
            };
            Real cheapest = 1e30;
            for (const Event& event : eventsOf(boxes, static_cast<int>(axis))) {
                if (event.at <= all.min()[axis] || event.at >= all.max()[axis]) continue;
                cheapest = std::min({cheapest, costAt(event.at, true), costAt(event.at, false)});
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
                EXPECT_NEAR(costAt(best.at, best.flatBelow), cheapest, 1e-9 * cheapest)
                    << "Is it said with the plane where it is and to which side flat boxes go?";
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
    best.cost = 1e30;
    sweepPlanes<Real>(eventsOf(boxes, 0), all, 0, 20, KdRule{}, best);
    KdPlane<Real> first = best;
    first.at = 42;
    sweepPlanes<Real>(eventsOf(boxes, 0), all, 0, 20, KdRule{}, first);
    EXPECT_EQ(first.at, 42) << "Is the best plane replaced by one that costs as much?";

    // All boxes fill the whole: events at the faces alone.
    const std::vector<Box> same(5, Box(Vec3::Zero(), Vec3::Ones()));
    best.cost = 1e30;
    sweepPlanes<Real>(eventsOf(same, 1), same[0], 1, 5, KdRule{}, best);
    EXPECT_EQ(best.cost, 1e30) << "Is a plane in a face of the box taken, which splits nothing?";
}

}  // namespace
}  // namespace caustic
