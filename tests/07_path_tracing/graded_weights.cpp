#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "integrator/path_density.h"

namespace caustic {
namespace {

// Densities over solid angle times |cosine| / d² at the vertex that they reach are over area: p→ takes the cosine at
// x_1, p← of x_0 that at x_0. A walk that ends one vertex earlier lacks p→ of x_1; one vertex earlier still, it lacks
// p→ of x_0 too, and the other walk adds p← of x_0. Everything is squared.
TEST(PathDensity, IsOverAreaAtTheNextVertex) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(1, {i});
        const Segment way = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 9)};
        const VertexPdf left = {random.uniform(0.1, 3), random.uniform(0.1, 3), true};
        const Real p0 = random.uniform(0.1, 3);
        const PathDensity there = PathDensity::start(p0, true).next(left, way);
        const Real p1 = left.forward * way.cosTo / way.squaredDistance;
        const Real back0 = way.cosFrom / way.squaredDistance;
        EXPECT_NEAR(there.dVCM * std::pow(p1, 2), 1, 1e-12) << "Which cosine, and which d? Is it squared?";
        EXPECT_NEAR(there.dVC * std::pow(p0 * p1 / back0, 2), 1, 1e-12) << "The way back ends where this one began.";
    }
}

// x_0 … x_2. At x_1 there is the strategy that ends before x_0, if a walk hits x_0 by chance. At x_2 there are that
// one, with what x_1 scatters back, and the one that ends at x_0. Equal cosines at both ends, as within a sphere.
TEST(PathDensity, GathersEarlierStrategies) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(2, {i});
        const Real p0 = random.uniform(0.1, 3);
        const bool canBeHit = i % 2 == 1;  // not a pinhole, not a light at a point
        const Real cosines[2] = {random.uniform(0.1, 1), random.uniform(0.1, 1)};
        const Segment ways[2] = {{cosines[0], cosines[0], random.uniform(0.5, 9)},
                                 {cosines[1], cosines[1], random.uniform(0.5, 9)}};
        const Real out = random.uniform(0.1, 3);
        const PathDensity first = PathDensity::start(p0, canBeHit).next({out, 1, true}, ways[0]);
        const Real p1 = out * ways[0].cosTo / ways[0].squaredDistance;
        const Real back0 = ways[0].cosFrom / ways[0].squaredDistance;
        const Real toFirst = canBeHit ? std::pow(back0 / (p0 * p1), 2) : 0;
        EXPECT_NEAR(first.dVC, toFirst, 1e-9 * (1 + toFirst)) << "Who can hit the first vertex by chance?";

        const VertexPdf left = {random.uniform(0.1, 3), random.uniform(0.1, 3), true};
        const PathDensity second = first.next(left, ways[1]);
        const Real p2 = left.forward * ways[1].cosTo / ways[1].squaredDistance;
        const Real back1 = ways[1].cosFrom / ways[1].squaredDistance;
        const Real expected = std::pow(back1 / p2, 2) * (1 / (p1 * p1) + left.reverse * left.reverse * toFirst);
        EXPECT_NEAR(second.dVC / expected, 1, 1e-9) << "What does x_1 scatter back, and is it squared?";
    }
}

// No walk ends at a vertex that scatters into one direction only, neither this one nor the other: two strategies less.
// Earlier ones stay, and go through it with a density of 1.
TEST(PathDensity, CutsNothingAtDeltaLobes) {
    const Segment ways[3] = {{0.7, 0.7, 2}, {0.8, 0.8, 3}, {1, 1, 1}};
    const PathDensity first = PathDensity::start(2, true).next({0.5, 1, true}, ways[0]);
    const PathDensity mirrored = first.next({1, 1, false}, ways[1]);
    EXPECT_EQ(mirrored.dVCM, 0)
        << "The other walk would have to end at the mirror's next vertex, and this one at the mirror.";
    EXPECT_NEAR(mirrored.dVC, first.dVC, 1e-12) << "The other walk would have to end at the mirror.";
    const PathDensity behind = mirrored.next({0.5, 0.25, true}, ways[2]);
    EXPECT_NEAR(behind.dVCM, 1 / (0.5 * 0.5), 1e-12) << "Behind the mirror's next vertex everything is as ever.";
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
        leftWalk[0] = PathDensity::start(ends[0], true);
        rightWalk[n - 1] = PathDensity::start(ends[1], true);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            leftWalk[i + 1] = leftWalk[i].next({right[i], left[i], true}, ways[i]);
            const std::size_t j = n - 1 - i;
            rightWalk[j - 1] = rightWalk[j].next({left[j], right[j], true}, ways[j - 1]);
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
