#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "surface/plane_net.h"

namespace caustic {
namespace {

Vec2 valueAt(const PlaneNet& net, Real u, Real v) {
    const auto weight = [](int n, int i, Real t) {
        return std::tgamma(n + 1) / std::tgamma(i + 1) / std::tgamma(n - i + 1) * std::pow(t, i) *
               std::pow(1 - t, n - i);
    };
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i <= net.degreeU; ++i) {
        for (int j = 0; j <= net.degreeV; ++j) {
            sum += weight(net.degreeU, i, u) * weight(net.degreeV, j, v) *
                   net.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
    }
    return sum;
}

// The two derivatives of a linear map: of any size and direction, up to 60 times as long as each other, seen from
// either side of the patch.
struct Frame {
    explicit Frame(Random& random) {
        const Real size = std::pow(10, random.uniform(-6, 6));
        const Real first = random.uniform(0, 2 * std::numbers::pi);
        const Real second = first + (random.below(2) == 0 ? 1 : -1) * random.uniform(0.6, 2.5);
        u = size * std::pow(10, random.uniform(-0.9, 0.9)) * Vec2(std::cos(first), std::sin(first));
        v = size * std::pow(10, random.uniform(-0.9, 0.9)) * Vec2(std::cos(second), std::sin(second));
    }

    /// What a value may be off by without saying anything.
    Real rounding() const { return 1e-15 * (u.norm() + v.norm()); }

    Vec2 u;
    Vec2 v;
};

// A net near a linear map, with a zero at (u, v). Each control point is moved by up to `bend` of the two derivatives,
// those within the net by `bendWithin`.
PlaneNet netWithZero(Random& random, const Frame& frame, int m, int n, const Vec2& zero, Real bend, Real bendWithin) {
    PlaneNet net;
    net.degreeU = m;
    net.degreeV = n;
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            const Real by = i > 0 && i < m && j > 0 && j < n ? bendWithin : bend;
            const Real u = Real(i) / m + by * random.uniform(-1, 1);
            const Real v = Real(j) / n + by * random.uniform(-1, 1);
            net.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = u * frame.u + v * frame.v;
        }
    }
    const Vec2 offset = valueAt(net, zero.x(), zero.y());
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) net.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] -= offset;
    }
    return net;
}

// Every third net is bent within alone, and far more: its border doesn't betray it.
TEST(Clipping, NeverCutsAZeroAway) {
    for (std::uint64_t i = 0; i < 3000; ++i) {
        Random random(1, {i});
        const Frame frame(random);
        const Vec2 zero(random.uniform(), random.uniform());
        const Real bend = i % 3 == 0 ? 0 : random.uniform(0, 0.3);
        const Real within = i % 3 == 0 ? random.uniform(0, 5) : bend;
        const int m = 1 + static_cast<int>(i % 5);
        const PatchDomain left = clippedDomain(netWithZero(random, frame, m, 3, zero, bend, within), frame.rounding());
        ASSERT_TRUE(left.u.lower <= zero.x() + 1e-12 && zero.x() <= left.u.upper + 1e-12)
            << "Net " << i << ": from what is i/m taken away, with which sign, and is it every point's?";
        ASSERT_TRUE(left.v.lower <= zero.y() + 1e-12 && zero.y() <= left.v.upper + 1e-12)
            << "Net " << i << ": which determinant belongs to v?";
    }
}

// The residual of a map is what is not linear in it, so a net bent by e leaves a few e; a linear one a single point.
TEST(Clipping, LeavesAsLittleAsTheNetIsBent) {
    for (const Real bend : {0.0, 1e-6, 1e-3}) {
        for (std::uint64_t i = 0; i < 500; ++i) {
            Random random(2, {i});
            const Frame frame(random);
            const Vec2 zero(random.uniform(), random.uniform());
            const int n = 1 + static_cast<int>(i % 4);
            const PatchDomain left =
                clippedDomain(netWithZero(random, frame, 3, n, zero, bend, bend), frame.rounding());
            ASSERT_LE(left.u.upper - left.u.lower, 20 * bend + 1e-11)
                << "Net " << i << ": is the map made close to the identity first, whatever its size and its side?";
            ASSERT_LE(left.v.upper - left.v.lower, 20 * bend + 1e-11) << "Net " << i << ": and v?";
        }
    }
}

TEST(Clipping, LeavesNothingWhereThereIsNoZero) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Frame frame(random);
        const Real outside = random.below(2) == 0 ? random.uniform(-1, -0.2) : random.uniform(1.2, 2);
        const bool inU = random.below(2) == 0;
        const Real other = random.uniform();
        const Vec2 zero(inU ? outside : other, inU ? other : outside);
        const PatchDomain left = clippedDomain(netWithZero(random, frame, 3, 3, zero, 1e-3, 1e-3), frame.rounding());
        ASSERT_TRUE(inU ? left.u.empty() : left.v.empty()) << "Net " << i << ": what is left of [0, 1]?";
    }
}

// Where a linear map's value is within the tolerance in both coordinates: a parallelogram around the zero, whose extent
// along u and v the inverse's rows tell. All of it is kept, and not more than four times as much.
TEST(Clipping, KeepsWhatIsWithinTheToleranceOfZero) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(6, {i});
        const Frame frame(random);
        const Real nearABorder = random.uniform(-0.05, 1.05);
        const Real within = random.uniform(0.3, 0.7);
        const Vec2 zero = random.below(2) == 0 ? Vec2(nearABorder, within) : Vec2(within, nearABorder);
        const PlaneNet net = netWithZero(random, frame, 2, 3, zero, 0, 0);
        const Real determinant = std::abs(frame.u.x() * frame.v.y() - frame.u.y() * frame.v.x());
        const Real tolerance = 0.1 * determinant / (frame.u.norm() + frame.v.norm());
        const Vec2 half = tolerance * Vec2(frame.v.lpNorm<1>(), frame.u.lpNorm<1>()) / determinant;
        const PatchDomain kept = clippedDomain(net, tolerance);
        for (const auto& [interval, at, by] : {std::tuple(kept.u, zero.x(), half.x()), {kept.v, zero.y(), half.y()}}) {
            if (at + by < 0 || at - by > 1) continue;
            ASSERT_LE(interval.lower, std::max(at - by, Real(0)) + 1e-9)
                << "Net " << i << ": how far may u and v be from the zero, when the value is off by the tolerance?";
            ASSERT_GE(interval.upper, std::min(at + by, Real(1)) - 1e-9) << "Net " << i << ": and on the other side?";
            ASSERT_GE(interval.lower, std::max(at - 4 * by, Real(0)) - 1e-9)
                << "Net " << i << ": is the tolerance turned into u and v by the size of what the net does along them?";
            ASSERT_LE(interval.upper, std::min(at + 4 * by, Real(1)) + 1e-9) << "Net " << i;
        }
    }
}

// A net whose mean derivatives make an angle below 1e-6 is seen edge-on, or folded: its inverse tells nothing. From
// there on it does, though all is magnified.
TEST(Clipping, CutsNothingOffANetSeenEdgeOn) {
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(7, {i});
        Frame frame(random);
        const Real ratio = (random.below(2) == 0 ? 1 : -1) * std::pow(10, random.uniform(-2, 2));
        const Vec2 across(-frame.u.y(), frame.u.x());
        const Vec2 outside(random.uniform(2, 3), random.uniform(-3, -2));
        frame.v = ratio * (frame.u + random.uniform(2e-6, 1e-3) * across);
        const PatchDomain none = clippedDomain(netWithZero(random, frame, 3, 2, outside, 0, 0), frame.rounding());
        ASSERT_TRUE(none.u.empty() || none.v.empty()) << "Net " << i << ": an angle above 1e-6 tells something.";
        frame.v = ratio * (frame.u + random.uniform(-0.9e-6, 0.9e-6) * across);
        const PatchDomain kept = clippedDomain(netWithZero(random, frame, 3, 2, outside, 0, 0), frame.rounding());
        ASSERT_EQ(kept.u.lower, 0) << "Net " << i << ": the derivatives make an angle below 1e-6. What is then known?";
        ASSERT_EQ(kept.u.upper, 1);
        ASSERT_EQ(kept.v.lower, 0);
        ASSERT_EQ(kept.v.upper, 1);
    }
}

}  // namespace
}  // namespace caustic
