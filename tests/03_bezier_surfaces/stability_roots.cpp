#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "expect_nothing_missed.h"
#include "revolution_cases.h"
#include "support/in_cube.h"
#include "surface/patch_roots.h"
#include "surface/revolved_segment.h"

namespace caustic {
namespace {

using test::expectNothingMissed;

constexpr int threads = 2;
constexpr std::uint64_t seed = 1;

TEST(RevolutionRoots, RandomChordsLoseNothing) {
    const RootExamination count = examineRevolution(0, 100'000, seed, threads);
    expectNothingMissed(count, "random chords");
    EXPECT_GT(count.meetings, 50'000);
    EXPECT_LT(count.raysInBand, count.rays / 500);
    for (std::size_t i = 1; i < count.nearest.size(); ++i) {
        EXPECT_GT(count.nearest[i].failures, 0) << count.nearest[i].method << " must fail somewhere.";
    }
}

// 2,000 random chords of each difficult surface and as many of each adversarial set, each against every segment.
TEST(RevolutionRoots, ComeInTheOrderOfU) {
    std::int64_t pairs = 0;
    for (const NamedProfile& one : difficultProfiles()) {
        const SurfaceOfRevolution surface(one.profile);
        const std::vector<RevolvedSegment> segments(one.profile.begin(), one.profile.end());
        for (const RaySet& set : revolutionRaySets()) {
            for (std::uint64_t i = 0; i < 2000; ++i) {
                Random random(seed, {i});
                const AxisRay line(set.make(surface, random), 0);
                for (const RevolvedSegment& segment : segments) {
                    const RevolvedSegment::Roots roots = segment.roots(line);
                    EXPECT_TRUE(std::ranges::is_sorted(roots, {}, &RevolvedRoot::u)) << one.name << ", " << set.name;
                    pairs += std::max(0, roots.count - 1);
                }
            }
        }
    }
    EXPECT_GT(pairs, 50'000) << "This would be a test of nothing.";
}

class AdversarialRevolution : public testing::TestWithParam<std::size_t> {};

TEST_P(AdversarialRevolution, LosesNothing) {
    expectNothingMissed(examineRevolution(GetParam(), 10'000, seed, threads), revolutionSetNames()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(EverySet, AdversarialRevolution, testing::Range(std::size_t{1}, revolutionSetNames().size()));

TEST(PatchRoots, RandomChordsLoseNothing) {
    const RootExamination count = examinePatches(0, 100'000, seed, threads);
    expectNothingMissed(count, "random chords");
    EXPECT_GT(count.meetings, 10'000);
    EXPECT_GT(count.nearest[1].failures, 0) << "A random start must fail somewhere.";
}

class AdversarialPatch : public testing::TestWithParam<std::size_t> {};

TEST_P(AdversarialPatch, LosesNothing) {
    expectNothingMissed(examinePatches(GetParam(), 1'600, seed, threads), patchSetNames()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(EverySet, AdversarialPatch, testing::Range(std::size_t{1}, patchSetNames().size()));

// A ray at the very edge that two patches share meets one of them: what is left must allow for rounding.
TEST(PatchRoots, SharedEdgesLetNothingThrough) {
    for (std::uint64_t k = 0; k < 40; ++k) {
        Random random(4, {k});
        std::vector<Vec3> points;
        for (int i = 0; i <= 3; ++i) {
            for (int j = 0; j <= 6; ++j) points.push_back(Vec3(i / 3.0, j / 3.0, 0) + 0.08 * test::inCube(random));
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
            const Vec3 from = at + Vec3(0, 0, random.below(2) == 0 ? 2 : -2) + 0.4 * test::inCube(random);
            const ShearedRay ray({from, at - from});
            ASSERT_GE(patchRoots(a, ray).size() + patchRoots(b, ray).size(), 1U) << "Patch " << k << ", ray " << i;
        }
    }
}

}  // namespace
}  // namespace caustic
