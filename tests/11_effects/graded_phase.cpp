#include <gtest/gtest.h>

#include <cmath>

#include "math/frame.h"
#include "medium/henyey_greenstein.h"
#include "support/direction_chi_square.h"

namespace caustic {
namespace {

const Vec3 directions[] = {Vec3(0.3, -0.8, 0.4).normalized(), Vec3(-0.2, 0.1, -0.9).normalized(), -Vec3::UnitZ(),
                           Vec3::UnitX()};

// A peak lies at −wo, which must not be a pole of the test's cells.
Frame cellsFor(const Vec3& wo) {
    const Frame around = Frame::around(wo);
    return {around.n, around.s, around.t};
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
        }
    }
}

}  // namespace
}  // namespace caustic
