#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "integrator/path_density.h"

namespace caustic {
namespace {

// A density over solid angle times |cosine| / d² at the far end is one over area: there for the way onwards, here for
// the way back.
TEST(PathDensity, IsOverAreaAtTheNextVertex) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(1, {i});
        const Segment way = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 9)};
        const ScatteringPdf pdf = {random.uniform(0.1, 3), random.uniform(0.1, 3), false};
        const PathDensity there = PathDensity{}.next(pdf, way);
        EXPECT_NEAR(there.forward, pdf.onwards * way.cosTo / way.squaredDistance, 1e-12)
            << "Which cosine, and which d?";
        EXPECT_NEAR(there.toArea, way.cosFrom / way.squaredDistance, 1e-12)
            << "The way back ends where this one began.";
        EXPECT_EQ(there.open, 1);
    }
}

// x_0 … x_3: after the second step the tail is, up to what the next vertices decide, 1/p(x_1)² · (o_1 +
// (p'(x_0)/p(x_0))² o_0): o_1 and o_0 say whether a walk from the other end may have ended there.
TEST(PathDensity, GathersEarlierStrategies) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(2, {i});
        PathDensity first;
        first.forward = random.uniform(0.1, 3);
        first.open = i % 2 == 0 ? 0 : 1;  // a pinhole, a light at a point: nobody hits it by chance
        const Segment way = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.5, 9)};
        const PathDensity second = first.next({random.uniform(0.1, 3), 1, false}, way);
        EXPECT_NEAR(second.tail, first.open / (first.forward * first.forward), 1e-9 * (1 + second.tail))
            << "Who can hit the first vertex by chance?";
        const ScatteringPdf pdf = {random.uniform(0.1, 3), random.uniform(0.1, 3), false};
        const PathDensity third = second.next(pdf, {0.4, 0.6, 2});
        const Real ratio = pdf.back * second.toArea / first.forward;
        const Real expected = (1 + ratio * ratio * first.open) / (second.forward * second.forward);
        EXPECT_NEAR(third.tail / expected, 1, 1e-9) << "Squared? And divided by this vertex's own density?";
    }
}

// No walk ends at a vertex that scatters into one direction only, neither this one nor the other: two strategies less.
// Earlier ones stay, and go through it with a density of 1.
TEST(PathDensity, CutsNothingAtDeltaLobes) {
    PathDensity first;
    first.forward = 2;
    const PathDensity second = first.next({0.5, 1, false}, {0.7, 0.9, 2});
    const PathDensity third = second.next({1, 1, true}, {0.8, 0.6, 3});
    EXPECT_EQ(third.open, 0)
        << "The other walk would have to end at the mirror's next vertex, and this one at the mirror.";
    const Real ratio = second.toArea / first.forward;
    EXPECT_NEAR(third.tail, ratio * ratio / (second.forward * second.forward), 1e-12)
        << "The other walk would have to end at the mirror.";
    const PathDensity fourth = third.next({0.5, 0.25, false}, {1, 1, 1});
    EXPECT_EQ(fourth.open, 1) << "Behind the mirror's next vertex everything is as ever.";
}

// Paths of n vertices of which both ends can be hit by chance; segments as within a sphere, equal cosines at both ends.
// Strategy s takes s vertices from one end. Its weight is p_s² / Σ p_j², p_s = Π p_L(x_i) (i < s) Π p_E(x_i) (i ≥ s),
// and over all s they sum to 1. Source: Veach, eq. 10.9.
TEST(StrategyWeights, AreTheSquaredDensitiesShareOfAll) {
    for (std::uint64_t k = 0; k < 300; ++k) {
        Random random(3, {k});
        const std::size_t n = 2 + k % 6;
        std::vector<Real> right(n);  // density over solid angle of going on to the next vertex, and to the one before
        std::vector<Real> left(n);
        std::vector<Segment> ways(n);
        for (std::size_t i = 0; i < n; ++i) {
            right[i] = random.uniform(0.2, 2);
            left[i] = random.uniform(0.2, 2);
            const Real cosine = random.uniform(0.2, 1);
            ways[i] = {cosine, cosine, 4 * cosine * cosine};
        }
        const Real ends[2] = {random.uniform(0.2, 2), random.uniform(0.2, 2)};
        const auto jacobian = [&](std::size_t i) { return ways[i].cosTo / ways[i].squaredDistance; };
        const auto fromLeft = [&](std::size_t i) { return i == 0 ? ends[0] : right[i - 1] * jacobian(i - 1); };
        const auto fromRight = [&](std::size_t i) { return i + 1 == n ? ends[1] : left[i + 1] * jacobian(i); };

        std::vector<PathDensity> leftWalk(n);
        std::vector<PathDensity> rightWalk(n);
        leftWalk[0].forward = ends[0];
        rightWalk[n - 1].forward = ends[1];
        for (std::size_t i = 0; i + 1 < n; ++i) {
            leftWalk[i + 1] = leftWalk[i].next({right[i], left[i], false}, ways[i]);
            const std::size_t j = n - 1 - i;
            rightWalk[j - 1] = rightWalk[j].next({left[j], right[j], false}, ways[j - 1]);
        }
        std::vector<Real> squares;
        Real all = 0;
        for (std::size_t s = 0; s <= n; ++s) {
            Real density = 1;
            for (std::size_t i = 0; i < n; ++i) density *= i < s ? fromLeft(i) : fromRight(i);
            squares.push_back(density * density);
            all += squares.back();
        }
        Real sum = 0;
        for (std::size_t s = 0; s <= n; ++s) {
            const Real before = s > 0 ? leftWalk[s - 1].others(fromRight(s - 1), left[s - 1]) : 0;
            const Real behind = s < n ? rightWalk[s].others(fromLeft(s), right[s]) : 0;
            const Real weight = strategyWeight(before, behind);
            EXPECT_NEAR(weight, squares[s] / all, 1e-10) << n << " vertices, " << s << " of them from the left";
            sum += weight;
        }
        EXPECT_NEAR(sum, 1, 1e-12) << "Does each strategy's weight know of all the others?";
    }
}

}  // namespace
}  // namespace caustic
