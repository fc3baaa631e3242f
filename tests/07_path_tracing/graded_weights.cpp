#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "integrator/path_density.h"

namespace caustic {
namespace {

// A path of n vertices, segments as within a sphere, with equal cosines at both ends. Some of its inner vertices may be
// mirrors: no walk ends there, and light is scattered with a density of 1. Its ends may be such that no walk hits them.
// Strategy s takes s vertices from the left; its density is p_s = Π p→(x_i) (i < s) Π p←(x_i) (i ≥ s) (Veach 10.9).
struct Path {
    Path(Random random, std::size_t count, bool mirrors, bool closed)
        : n(count), right(n), left(n), ways(n), connectible(n) {
        for (std::size_t i = 0; i < n; ++i) {
            connectible[i] = !mirrors || i == 0 || i + 1 == n || random.uniform() < 0.6;
            right[i] = connectible[i] ? random.uniform(0.2, 2) : 1;
            left[i] = connectible[i] ? random.uniform(0.2, 2) : 1;
            const Real cosine = random.uniform(0.2, 1);
            ways[i] = {cosine, cosine, 4 * cosine * cosine};
        }
        for (int i = 0; i < 2; ++i) {
            ends[i] = random.uniform(0.2, 2);
            hit[i] = !closed || random.uniform() < 0.5;
        }
    }

    Real jacobian(std::size_t i) const { return ways[i].cosTo / ways[i].squaredDistance; }
    Real fromLeft(std::size_t i) const { return i == 0 ? ends[0] : right[i - 1] * jacobian(i - 1); }
    Real fromRight(std::size_t i) const { return i + 1 == n ? ends[1] : left[i + 1] * jacobian(i); }

    bool possible(std::size_t s) const {
        if (s == 0 || s == n) return hit[s == 0 ? 0 : 1];
        return connectible[s - 1] && connectible[s];
    }
    Real density(std::size_t s) const {
        Real product = 1;
        for (std::size_t i = 0; i < n; ++i) product *= i < s ? fromLeft(i) : fromRight(i);
        return product;
    }

    // What the walk from the left knows at each of its vertices.
    std::vector<PathDensity> fromTheLeft() const {
        std::vector<PathDensity> walk = {PathDensity::start(ends[0], hit[0])};
        for (std::size_t i = 0; i + 1 < n; ++i)
            walk.push_back(walk.back().next({right[i], left[i], connectible[i]}, ways[i]));
        return walk;
    }
    std::vector<PathDensity> fromTheRight() const {
        std::vector<PathDensity> walk = {PathDensity::start(ends[1], hit[1])};
        for (std::size_t i = n - 1; i > 0; --i)
            walk.insert(walk.begin(), walk.front().next({left[i], right[i], connectible[i]}, ways[i - 1]));
        return walk;
    }

    std::size_t n;
    std::vector<Real> right;  // density over solid angle of going on to the next vertex
    std::vector<Real> left;   // and to the one before
    std::vector<Segment> ways;
    std::vector<bool> connectible;
    Real ends[2] = {};
    bool hit[2] = {};
};

// dVC of each vertex of a walk: the squared densities of all strategies in which it ends two vertices earlier or more,
// over that of the one in which it ends there, but for two factors.
void expectSums(const Path& path, const char* question) {
    const std::vector<PathDensity> walk = path.fromTheLeft();
    for (std::size_t s = 1; s < path.n; ++s) {
        Real sum = 0;
        for (std::size_t j = 0; j + 2 <= s; ++j)
            sum += path.possible(j) ? std::pow(path.density(j) / path.density(s), 2) : 0;
        const Real without = sum / std::pow(path.fromRight(s - 1) * path.left[s - 1], 2);
        EXPECT_NEAR(walk[s - 1].dVC, without, 1e-10 * (1 + without)) << "vertex " << s - 1 << ": " << question;
    }
}

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

// The strategies are all there in which a walk ends earlier still, up to the one in which the other walk hits the first
// vertex by chance, if a walk does: not a pinhole, not a light at a point.
TEST(PathDensity, GathersEarlierStrategies) {
    for (std::uint64_t k = 0; k < 400; ++k)
        expectSums(Path(Random(2, {k}), 2 + k % 6, false, true),
                   "Who can hit the first vertex by chance? What do vertices scatter back, and is it squared?");
}

// No walk ends at a vertex that scatters into one direction only, neither this one nor the other: two strategies less.
// Earlier ones stay, and go through it with a density of 1, which is over solid angle: over area it takes the cosines
// and the distance as any other.
TEST(PathDensity, CutsNothingAtDeltaLobes) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(4, {i});
        const Real lamp = random.uniform(0.2, 1);
        const Segment toMirror = {lamp, lamp, random.uniform(0.1, 9)};
        const Segment onwards = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 9)};
        const PathDensity first = PathDensity::start(2, true).next({0.5, 1, true}, toMirror);
        const PathDensity mirrored = first.next({1, 1, false}, onwards);
        EXPECT_EQ(mirrored.dVCM, 0)
            << "The other walk would have to end at the mirror's next vertex, and this one at the mirror.";
        const Real there = onwards.cosTo / onwards.squaredDistance;
        const Real back = onwards.cosFrom / onwards.squaredDistance;
        EXPECT_NEAR(mirrored.dVC / (std::pow(back / there, 2) * first.dVC), 1, 1e-12)
            << "The other walk would have to end at the mirror. Is a lobe's probability over solid angle, or over "
               "area?";
        const PathDensity behind = mirrored.next({0.5, 0.25, true}, {1, 1, 1});
        EXPECT_NEAR(behind.dVCM, 1 / (0.5 * 0.5), 1e-12) << "Behind the mirror's next vertex everything is as ever.";
        EXPECT_NEAR(behind.dVC / (4 * mirrored.dVC / 16), 1, 1e-12) << "Behind the mirror everything is as ever.";
    }
    for (std::uint64_t k = 0; k < 400; ++k)
        expectSums(Path(Random(5, {k}), 3 + k % 6, true, false), "Which strategies does a mirror take away?");
}

// The weight of strategy s is p_s² / Σ p_j², and over all that there are they sum to 1.
TEST(StrategyWeights, AreTheSquaredDensitiesShareOfAll) {
    for (std::uint64_t k = 0; k < 400; ++k) {
        const Path path(Random(3, {k}), 2 + k % 6, false, false);
        const std::vector<PathDensity> left = path.fromTheLeft();
        const std::vector<PathDensity> right = path.fromTheRight();
        Real all = 0;
        for (std::size_t s = 0; s <= path.n; ++s) all += std::pow(path.density(s), 2);
        Real sum = 0;
        for (std::size_t s = 0; s <= path.n; ++s) {
            const Real before = s > 0 ? left[s - 1].others(path.fromRight(s - 1), path.left[s - 1]) : 0;
            const Real behind = s < path.n ? right[s].others(path.fromLeft(s), path.right[s]) : 0;
            const Real weight = strategyWeight(before, behind);
            EXPECT_NEAR(weight, std::pow(path.density(s), 2) / all, 1e-10)
                << path.n << " vertices, " << s
                << " of them from the left: does the weight know of all other strategies?";
            sum += weight;
        }
        EXPECT_NEAR(sum, 1, 1e-12) << "Does each strategy's weight know of all the others?";
    }
}

}  // namespace
}  // namespace caustic
