#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "support/in_cube.h"
#include "surface/patch_roots.h"

namespace caustic {
namespace {

using test::inCube;

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

// A net near a linear map, with a zero at (u, v).
PlaneNet netWithZero(Random& random, int m, int n, Real u, Real v, Real bend) {
    PlaneNet net;
    net.degreeU = m;
    net.degreeV = n;
    const Vec2 a(random.uniform(0.5, 2), random.uniform(-0.4, 0.4));
    const Vec2 b(random.uniform(-0.4, 0.4), random.uniform(0.5, 2));
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            const Vec2 noise(random.uniform(-1, 1), random.uniform(-1, 1));
            net.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                Real(i) / m * a + Real(j) / n * b + bend * noise;
        }
    }
    const Vec2 offset = valueAt(net, u, v);
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) net.point[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] -= offset;
    }
    return net;
}

TEST(Clipping, NeverCutsAZeroAway) {
    for (std::uint64_t i = 0; i < 3000; ++i) {
        Random random(1, {i});
        const Real u = random.uniform();
        const Real v = random.uniform();
        const PlaneNet net = netWithZero(random, 1 + static_cast<int>(i % 4), 3, u, v, random.uniform(0, 0.3));
        const PatchDomain left = clippedDomain(net, 1e-15);
        EXPECT_TRUE(left.u.lower <= u + 1e-12 && u <= left.u.upper + 1e-12)
            << "Net " << i << ": from what is i/m taken away, and with which sign?";
        EXPECT_TRUE(left.v.lower <= v + 1e-12 && v <= left.v.upper + 1e-12)
            << "Net " << i << ": which determinant belongs to v?";
    }
}

// The residual of a map is what is not linear in it, so a net bent by e leaves a few e; a linear one a single point.
TEST(Clipping, LeavesAsLittleAsTheNetIsBent) {
    for (const Real bend : {0.0, 1e-6, 1e-3}) {
        for (std::uint64_t i = 0; i < 500; ++i) {
            Random random(2, {i});
            const PlaneNet net = netWithZero(random, 3, 3, random.uniform(), random.uniform(), bend);
            const PatchDomain left = clippedDomain(net, 1e-15);
            EXPECT_LE(left.u.upper - left.u.lower, 20 * bend + 1e-13) << "Is the map made close to the identity first?";
            EXPECT_LE(left.v.upper - left.v.lower, 20 * bend + 1e-13);
        }
    }
}

TEST(Clipping, LeavesNothingWhereThereIsNoZero) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Real outside = random.below(2) == 0 ? random.uniform(-1, -0.2) : random.uniform(1.2, 2);
        const bool inU = random.below(2) == 0;
        const Real other = random.uniform();
        const PlaneNet net = netWithZero(random, 3, 3, inU ? outside : other, inU ? other : outside, 1e-3);
        const PatchDomain left = clippedDomain(net, 1e-15);
        EXPECT_TRUE(inU ? left.u.empty() : left.v.empty()) << "Net " << i << ": what is left of [0, 1]?";
    }
}

// A ray at the very edge that two patches share meets one of them: what is left must allow for rounding. A zero that is
// outside by less than the tolerance stays.
TEST(Clipping, SharedEdgesLetNothingThrough) {
    for (std::uint64_t i = 0; i < 400; ++i) {
        Random random(5, {i});
        const Real beyond = random.below(2) == 0 ? -1e-9 : 1 + 1e-9;
        const bool inU = random.below(2) == 0;
        const Real other = random.uniform(0.1, 0.9);
        const PlaneNet net = netWithZero(random, 3, 3, inU ? beyond : other, inU ? other : beyond, 0);
        const PatchDomain kept = clippedDomain(net, 1e-6);
        EXPECT_FALSE(kept.u.empty() || kept.v.empty()) << "Net " << i << ": what may rounding have done to the net?";
    }
    for (std::uint64_t k = 0; k < 40; ++k) {
        Random random(4, {k});
        std::vector<Vec3> points;
        for (int i = 0; i <= 3; ++i) {
            for (int j = 0; j <= 6; ++j) points.push_back(Vec3(i / 3.0, j / 3.0, 0) + 0.08 * inCube(random));
        }
        std::vector<Vec3> left;
        std::vector<Vec3> right;
        for (std::size_t i = 0; i <= 3; ++i) {
            for (std::size_t j = 0; j <= 3; ++j) {
                left.push_back(points[7 * i + j]);
                right.push_back(points[7 * i + 6 - j]);
            }
        }
        const BezierPatch a(3, 3, left);
        const BezierPatch b(3, 3, right);
        for (int i = 0; i < 250; ++i) {
            const Vec3 at = a.evaluate(random.uniform(0.02, 0.98), 1).point;
            const Vec3 from = at + Vec3(0, 0, random.below(2) == 0 ? 2 : -2) + 0.4 * inCube(random);
            const ShearedRay ray({from, at - from});
            EXPECT_GE(patchRoots(a, ray).size() + patchRoots(b, ray).size(), 1U)
                << "Patch " << k << ", ray " << i << ": is the domain padded by the tolerance?";
        }
    }
}

}  // namespace
}  // namespace caustic
