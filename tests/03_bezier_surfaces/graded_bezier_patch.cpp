#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "curve/bezier_patch.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

BezierPatch randomPatch(std::uint64_t seed, int m, int n, Real size = 1, const Vec3& at = Vec3::Zero()) {
    Random random(seed, {static_cast<std::uint64_t>(m), static_cast<std::uint64_t>(n)});
    std::vector<Vec3> points;
    for (int i = 0; i < (m + 1) * (n + 1); ++i) points.push_back(at + size * inCube(random));
    return {m, n, std::move(points)};
}

Real bernstein(int n, int i, Real t) {
    return std::tgamma(n + 1) / std::tgamma(i + 1) / std::tgamma(n - i + 1) * std::pow(t, i) * std::pow(1 - t, n - i);
}

// Sum of b_i(u) c_j(v) P_ij over points that a function names.
template <typename PointAt>
Vec3 bernsteinSum(int m, int n, Real u, Real v, const PointAt& pointAt) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) sum += bernstein(m, i, u) * bernstein(n, j, v) * pointAt(i, j);
    }
    return sum;
}

Vec3 byDefinition(const BezierPatch& patch, Real u, Real v) {
    return bernsteinSum(patch.degreeU(), patch.degreeV(), u, v,
                        [&](int i, int j) -> const Vec3& { return patch.controlPoint(i, j); });
}

// Outside of [0, 1]² the weights grow to some hundreds.
TEST(BezierPatch, PointMatchesBernsteinSum) {
    for (const auto& [m, n] : {std::pair(3, 3), std::pair(1, 4), std::pair(5, 2), std::pair(1, 1)}) {
        const BezierPatch patch = randomPatch(1, m, n);
        for (const Real u : {-0.3, 0.0, 0.2, 0.75, 1.0, 1.4}) {
            for (const Real v : {-0.4, 0.0, 0.4, 0.9, 1.0, 1.3}) {
                EXPECT_LE((patch.evaluate(u, v).point - byDefinition(patch, u, v)).norm(), 1e-12)
                    << "Degrees " << m << " and " << n << ", u = " << u << ", v = " << v
                    << ": does each row have its own length, does v run along it, and are u and v used as they come?";
            }
        }
    }
}

// The derivative of degree n - 1 over n times the differences of neighbours (Farin 2002, eq. 14.13). A patch far from
// the origin has the same derivatives: their differences are as exact as the points.
TEST(BezierPatch, DerivativesMatchDifferences) {
    for (const auto& [size, far] : {std::pair(1.0, 0.0), std::pair(1e-6, 0.0), std::pair(1.0, 1e6)}) {
        for (const auto& [m, n] : {std::pair(3, 3), std::pair(2, 5), std::pair(1, 4), std::pair(4, 1)}) {
            const BezierPatch patch = randomPatch(2, m, n, size, far * Vec3(1, -0.7, 0.4));
            const Real rounding = 1e-13 * size + 1e-14 * far;
            for (const Real u : {-0.2, 0.0, 0.1, 0.6, 1.0}) {
                for (const Real v : {0.0, 0.3, 0.8, 1.0, 1.2}) {
                    const SurfaceJet jet = patch.evaluate(u, v);
                    const auto stepU = [&, degree = m](int i, int j) -> Vec3 {
                        return degree * (patch.controlPoint(i + 1, j) - patch.controlPoint(i, j));
                    };
                    const auto stepV = [&, degree = n](int i, int j) -> Vec3 {
                        return degree * (patch.controlPoint(i, j + 1) - patch.controlPoint(i, j));
                    };
                    EXPECT_LE((jet.du - bernsteinSum(m - 1, n, u, v, stepU)).norm(), 100 * rounding)
                        << "Is ∂u the last pair's difference times the degree in u?";
                    EXPECT_LE((jet.dv - bernsteinSum(m, n - 1, u, v, stepV)).norm(), 100 * rounding)
                        << "Is ∂v taken along the rows, and then blended in u?";
                }
            }
        }
    }
}

// A point of the left part at v is the whole's at t v; of the right part, at t + (1 - t) v.
TEST(BezierPatch, PartsOfASplitAreThePatch) {
    for (const auto& [m, n] : {std::pair(2, 4), std::pair(4, 1), std::pair(1, 3)}) {
        const BezierPatch patch = randomPatch(3, m, n);
        for (const Real t : {0.0, 0.25, 0.5, 0.8, 1.0}) {
            const auto [left, right] = patch.splitV(t);
            ASSERT_EQ(left.degreeU(), m);
            ASSERT_EQ(right.degreeV(), n);
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
