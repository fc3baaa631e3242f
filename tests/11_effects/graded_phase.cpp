#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/frame.h"
#include "medium/henyey_greenstein.h"
#include "support/direction_chi_square.h"

namespace caustic {
namespace {

const Vec3 directions[] = {Vec3(0.3, -0.8, 0.4).normalized(), Vec3(-0.5, 0.7, 0.3).normalized(),
                           Vec3(-0.2, 0.1, -0.9).normalized(), -Vec3::UnitZ(), Vec3::UnitX()};

// A peak lies at −wo, which must not be a pole of the test's cells.
Frame cellsFor(const Vec3& wo) {
    const Frame around = Frame::around(wo);
    return {around.n, around.s, around.t};
}

// Henyey and Greenstein's distribution of cosθ.
Real shareBelow(Real cosine, Real g) {
    return (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * cosine) - 1 / (1 + g));
}

// Chi-square of directions against p; for g next to 0 a formula that divides by g has no digits left.
TEST(HenyeyGreenstein, SamplesFollowThePhaseFunction) {
    std::uint64_t seed = 1;
    for (const Real g : {-0.95, -0.4, 0.0, 1e-16, 0.3, 0.8, 0.97}) {
        const HenyeyGreenstein phase(g);
        for (const Vec3& wo : directions) {
            const test::DirectionSampling sampling = {
                [&](const Vec2& u, Real) { return std::optional<Vec3>(phase.sample(wo, u).wi); },
                [&](const Vec3& wi) { return phase.p(wo, wi); }};
            EXPECT_GE(test::directionProbability(sampling, 60'000, seed++, cellsFor(wo)), 1e-6)
                << "g = " << g << ": is it the inverse of the distribution of cosθ, around where light was going?";
        }
    }
    // Numbers in equal steps turn light by angles of which each has the same share, and all the way round: whichever of
    // the two decides about which.
    constexpr int steps = 300;
    for (const Real g : {-0.9, -0.3, 0.5, 0.97}) {
        const HenyeyGreenstein phase(g);
        const Vec3 wo = directions[0];
        const Frame around = Frame::around(-wo);
        std::vector<Real> shares;
        std::vector<Real> turns;
        for (int i = 0; i < steps; ++i) {
            const Vec3 wi = phase.sample(wo, Vec2::Constant((i + 0.5) / steps)).wi;
            shares.push_back(shareBelow(wi.dot(-wo), g));
            turns.push_back(std::atan2(wi.dot(around.t), wi.dot(around.s)) / (2 * std::numbers::pi));
        }
        std::sort(shares.begin(), shares.end());
        std::sort(turns.begin(), turns.end());
        for (int i = 0; i < steps; ++i) {
            const auto at = static_cast<std::size_t>(i);
            ASSERT_NEAR(shares[at], (i + 0.5) / steps, 1e-9)
                << "g = " << g << ": Is it the inverse of the distribution?";
            ASSERT_NEAR(turns[at] - turns[0], i / Real(steps), 1e-9) << "Does the other number turn it once around?";
        }
    }
}

// What comes with the direction: p and the density of it, which are the same; a unit vector, at the sharpest peaks too.
TEST(HenyeyGreenstein, SampleSaysItsDensity) {
    for (const Real g : {-0.999, -0.3, 0.0, 0.5, 0.99, 0.9999}) {
        const HenyeyGreenstein phase(g);
        for (const Vec3& wo : directions) {
            for (int i = 0; i < 200; ++i) {
                const PhaseSample one = phase.sample(wo, {(i + 0.5) / 200, std::fmod(0.618 * i, 1.0)});
                EXPECT_NEAR(one.wi.norm(), 1, 1e-12);
                EXPECT_NEAR(one.p / phase.p(wo, one.wi), 1, 1e-9) << "p of wo and wi";
                EXPECT_NEAR(one.pdfW / one.p, 1, 1e-9) << "Sampled in proportion to p: which density is that?";
            }
            for (const Real u : {0.0, 0.25, 0.5, 0.75, 1 - 0x1p-53}) {
                const PhaseSample one = phase.sample(wo, {u, 0.3});
                EXPECT_NEAR(one.wi.norm(), 1, 1e-12) << "g = " << g << ", u = " << u << ": is anything divided by 0?";
            }
        }
    }
}

}  // namespace
}  // namespace caustic
