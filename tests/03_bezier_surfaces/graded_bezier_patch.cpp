#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "curve/bezier_patch.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

BezierPatch randomPatch(std::uint64_t seed, int m, int n) {
    Random random(seed, {static_cast<std::uint64_t>(m), static_cast<std::uint64_t>(n)});
    std::vector<Vec3> points;
    for (int i = 0; i < (m + 1) * (n + 1); ++i) points.push_back(inCube(random));
    return {m, n, std::move(points)};
}

Real bernstein(int n, int i, Real t) {
    return std::tgamma(n + 1) / std::tgamma(i + 1) / std::tgamma(n - i + 1) * std::pow(t, i) * std::pow(1 - t, n - i);
}

// The definition: sum of b_i(u) c_j(v) P_ij.
Vec3 byDefinition(const BezierPatch& patch, Real u, Real v) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i <= patch.degreeU(); ++i) {
        for (int j = 0; j <= patch.degreeV(); ++j) {
            sum += bernstein(patch.degreeU(), i, u) * bernstein(patch.degreeV(), j, v) * patch.controlPoint(i, j);
        }
    }
    return sum;
}

TEST(BezierPatch, PointMatchesBernsteinSum) {
    for (const auto& [m, n] : {std::pair(3, 3), std::pair(1, 4), std::pair(5, 2)}) {
        const BezierPatch patch = randomPatch(1, m, n);
        for (const Real u : {0.0, 0.2, 0.75, 1.0}) {
            for (const Real v : {0.0, 0.4, 0.9, 1.0}) {
                EXPECT_LE((patch.evaluate(u, v).point - byDefinition(patch, u, v)).norm(), 1e-13)
                    << "Degrees " << m << " and " << n << ": does each row have its own length, and v run along it?";
            }
        }
    }
}

// Central differences of the definition, of order h².
TEST(BezierPatch, DerivativesMatchDifferences) {
    constexpr Real h = 1e-5;
    for (const auto& [m, n] : {std::pair(3, 3), std::pair(2, 5)}) {
        const BezierPatch patch = randomPatch(2, m, n);
        for (const Real u : {0.1, 0.6}) {
            for (const Real v : {0.3, 0.8}) {
                const SurfaceJet jet = patch.evaluate(u, v);
                const Vec3 du = (byDefinition(patch, u + h, v) - byDefinition(patch, u - h, v)) / (2 * h);
                const Vec3 dv = (byDefinition(patch, u, v + h) - byDefinition(patch, u, v - h)) / (2 * h);
                EXPECT_LE((jet.du - du).norm(), 1e-7) << "Is ∂u the last pair's difference times the degree in u?";
                EXPECT_LE((jet.dv - dv).norm(), 1e-7) << "Is ∂v taken along the rows, and then blended in u?";
            }
        }
    }
}

// A point of the left part at v is the whole's at t v; of the right part, at t + (1 - t) v.
TEST(BezierPatch, PartsOfASplitAreThePatch) {
    const BezierPatch patch = randomPatch(3, 2, 4);
    for (const Real t : {0.25, 0.5, 0.8}) {
        const auto [left, right] = patch.splitV(t);
        for (const Real u : {0.0, 0.35, 1.0}) {
            for (const Real v : {0.0, 0.5, 1.0}) {
                EXPECT_LE((byDefinition(left, u, v) - byDefinition(patch, u, t * v)).norm(), 1e-13)
                    << "Which points of de Casteljau's triangle are the left part's?";
                EXPECT_LE((byDefinition(right, u, v) - byDefinition(patch, u, t + (1 - t) * v)).norm(), 1e-13)
                    << "In which order do the right part's points come?";
            }
        }
    }
}

// Both parts have the very same points where they meet: a crack of one rounding lets rays through.
TEST(BezierPatch, PartsOfASplitShareTheirEdgeExactly) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const BezierPatch patch = randomPatch(seed, 3, 3);
        const auto [left, right] = patch.splitV(0.3);
        for (int i = 0; i <= 3; ++i) {
            EXPECT_EQ(left.controlPoint(i, 3), right.controlPoint(i, 0)) << "Is the point at t computed once?";
            EXPECT_EQ(left.controlPoint(i, 0), patch.controlPoint(i, 0));
            EXPECT_EQ(right.controlPoint(i, 3), patch.controlPoint(i, 3));
        }
    }
}

}  // namespace
}  // namespace caustic
