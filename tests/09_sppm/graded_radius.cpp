#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "integrator/radius_rule.h"

namespace caustic {
namespace {

// R_i² / R_(i-1)² = (i + α)/(i + 1), from R_0 on; far out R_i² i^(1 − α) → R_0² / Γ(1 + α).
TEST(RadiusRule, PassByPassAsTheoryHasIt) {
    for (const Real alpha : {0.01, 0.3, 2.0 / 3, 0.99}) {
        for (const Real first : {1e-4, 0.7, 30.0}) {
            EXPECT_NEAR(radiusOfPass(first, alpha, 0) / first, 1, 1e-9)
                << "The first pass has the radius it starts with.";
            Real squared = 1;
            for (int i = 1; i <= 3000; ++i) {
                squared *= (i + alpha) / (i + 1);
                ASSERT_NEAR(radiusOfPass(first, alpha, i) / first / std::sqrt(squared), 1, 1e-8)
                    << "pass " << i << ", alpha " << alpha << ": Is the ratio that of the radii, or of their squares?";
            }
            const Real far = radiusOfPass(first, alpha, 200'000) / first;
            EXPECT_NEAR(far * far * std::pow(200'000, 1 - alpha) * std::tgamma(1 + alpha), 1, 1e-4);
        }
    }
}

PointStatistics statistics(Random& random) {
    return {random.uniform(1e-3, 2), random.uniform(0, 500),
            Color(random.uniform(), 3 * random.uniform(), 0.1 * random.uniform())};
}

// N' = N + αM, R' = R √((N + αM)/(N + M)), τ' = (τ + Φ) R'²/R².
TEST(RadiusRule, APointKeepsAShareOfWhatItFinds) {
    Random random(4, {1});
    for (int trial = 0; trial < 1000; ++trial) {
        const PointStatistics before = statistics(random);
        const auto m = static_cast<std::int64_t>(1 + random.below(300));
        const Gathered found = {m, Color(random.uniform(), random.uniform(), random.uniform())};
        const Real alpha = random.uniform(0.01, 0.99);
        PointStatistics after = before;
        update(after, found, alpha);
        const Real n = before.photons;
        const Real kept = (n + alpha * static_cast<Real>(m)) / (n + static_cast<Real>(m));
        ASSERT_NEAR(after.photons, n + alpha * static_cast<Real>(m), 1e-9 * (n + 300)) << "How many photons count?";
        ASSERT_NEAR(after.radius / before.radius, std::sqrt(kept), 1e-12) << "Photons go with the area.";
        ASSERT_LE((after.flux / ((before.flux + found.flux) * kept) - 1).abs().maxCoeff(), 1e-9)
            << "Which part of old and new flux is within the smaller disc?";
    }
    PointStatistics crowded = {1, 0, Color::Zero()};
    update(crowded, {33'554'433, Color::Ones()}, 0.5);
    EXPECT_EQ(crowded.photons, 33'554'433 / 2.0) << "Is any of so many lost?";
}

// A pass that brings nothing leaves everything as it was, the first one too: 0/0 is no share.
TEST(RadiusRule, NothingFoundChangesNothing) {
    Random random(4, {2});
    for (int trial = 0; trial < 100; ++trial) {
        PointStatistics pixel = statistics(random);
        if (trial % 2 == 0) pixel.photons = 0;
        const PointStatistics before = pixel;
        update(pixel, {0, Color::Zero()}, 0.7);
        ASSERT_EQ(pixel.radius, before.radius) << "Is there a 0/0?";
        ASSERT_EQ(pixel.photons, before.photons);
        ASSERT_TRUE((pixel.flux == before.flux).all());
    }
}

}  // namespace
}  // namespace caustic
