#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "material/fresnel.h"

namespace caustic {
namespace {

// At normal incidence R = ((η − 1)/(η + 1))². At Brewster's angle, tan θ = η, only light polarised across the plane of
// incidence is reflected: R = ½ ((η² − 1)/(η² + 1))². In between, with both angles, the amplitudes are
// sin(θ − θ')/sin(θ + θ') and tan(θ − θ')/tan(θ + θ'). Source: Hecht 4.6, 8.6.
TEST(Fresnel, NormalAndBrewstersAngleHaveClosedForms) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(1, {i});
        const Real eta = random.uniform(0.3, 3);
        const Real atNormal = (eta - 1) / (eta + 1);
        EXPECT_NEAR(fresnelDielectric(1, eta), atNormal * atNormal, 1e-14) << "The mean of two squares?";
        const Real across = (eta * eta - 1) / (eta * eta + 1);
        EXPECT_NEAR(fresnelDielectric(1 / std::sqrt(1 + eta * eta), eta), across * across / 2, 1e-14)
            << "Which of the two polarisations has no reflection here?";
        const Real angle = std::asin(random.uniform(0.05, 0.99) * std::min(eta, Real(1)));
        const Real beyond = std::asin(std::sin(angle) / eta);
        const Real perpendicular = std::sin(angle - beyond) / std::sin(angle + beyond);
        const Real parallel = std::tan(angle - beyond) / std::tan(angle + beyond);
        EXPECT_NEAR(fresnelDielectric(std::cos(angle), eta), (perpendicular * perpendicular + parallel * parallel) / 2,
                    1e-12)
            << "Is each amplitude that of Fresnel?";
    }
}

// From the denser side, where sin θ > η: total reflection, and nothing jumps at the critical angle.
TEST(Fresnel, AllIsReflectedBeyondTheCriticalAngle) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Real eta = random.uniform(0.3, 0.99);
        const Real critical = std::sqrt(1 - eta * eta);
        EXPECT_EQ(fresnelDielectric(random.uniform(0, 0.999 * critical), eta), 1)
            << "What is the sine on the other side?";
        EXPECT_GT(fresnelDielectric(critical * (1 + 1e-12), eta), 0.99) << "Does it rise to 1 just before?";
        EXPECT_LE(fresnelDielectric(critical, eta), 1) << "A root of something a little below 0?";
        EXPECT_EQ(fresnelDielectric(0, eta), 1) << "What is reflected along the surface?";
    }
    for (const Real eta : {1.0, 1.5}) {
        const Real along = fresnelDielectric(0, eta);
        EXPECT_TRUE(along >= 0 && along <= 1) << "What is reflected along the surface: 0/0?";
    }
}

// η = 1.5: R0 = 0.04; the rest rises with the fifth power.
TEST(Schlick, RisesWithTheFifthPower) {
    EXPECT_NEAR(schlick(1, 1.5), 0.04, 1e-15) << "R0 is a square.";
    EXPECT_NEAR(schlick(0.5, 1.5), 0.04 + 0.96 / 32, 1e-15) << "The fifth power of 1 − cos?";
    EXPECT_NEAR(schlick(0, 1.5), 1, 1e-15) << "Along the surface all is reflected.";
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random(4, {i});
        const Real eta = random.uniform(1, 3);
        const Real cosine = random.uniform();
        const Real r0 = std::pow((eta - 1) / (eta + 1), 2);
        EXPECT_NEAR((schlick(cosine, eta) - r0) / (1 - r0), std::pow(1 - cosine, 5), 1e-12)
            << "How much of the way from R0 to 1 is it?";
    }
}

// Seen from inside, the curve has to end at the critical angle, not along the surface.
TEST(Schlick, CountsTheAngleOnTheThinnerSide) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Real eta = random.uniform(0.3, 0.95);
        const Real critical = std::sqrt(1 - eta * eta);
        EXPECT_GT(schlick(critical * (1 + 1e-9), eta), 0.99) << "Is the angle measured outside, where it is larger?";
        EXPECT_NEAR(schlick(random.uniform(0, 0.999 * critical), eta), 1, 1e-15) << "And beyond?";
        EXPECT_NEAR(schlick(0, eta), 1, 1e-15) << "And beyond?";
        // Light takes the same way back: the same share on both sides.
        const Real outside = random.uniform(0.1, 1);
        const Real inside = std::sqrt(1 - eta * eta * (1 - outside * outside));
        EXPECT_NEAR(schlick(inside, eta), schlick(outside, 1 / eta), 1e-11) << "Which cosine is it on the denser side?";
    }
}

}  // namespace
}  // namespace caustic
