#include <gtest/gtest.h>

#include <cmath>

#include "camera/box_filter.h"
#include "core/random.h"
#include "furnace.h"
#include "integrator/ray_tracer.h"
#include "material/dielectric_material.h"
#include "material/fresnel.h"
#include "material/rough_conductor_bsdf.h"
#include "reference.h"
#include "sampling/independent_sampler.h"
#include "scenes.h"
#include "support/bsdf_checks.h"

namespace caustic {
namespace {

// Fresnel's own forms, by the sines and tangents of both angles.
TEST(Fresnel, AgreesWithSinesAndTangents) {
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        Random random(1, {i});
        const Real eta = random.uniform(0.3, 3);
        const Real cosO = random.uniform();
        EXPECT_NEAR(fresnelDielectric(cosO, eta), referenceDielectric(cosO, eta).mean(), 1e-10);
    }
}

// The same from both sides: F(cosO, η) = F(cosI, 1/η).
TEST(Fresnel, IsTheSameFromBothSides) {
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        Random random(2, {i});
        const Real eta = random.uniform(1, 3);
        const Real cosO = random.uniform(0.001, 1);
        const Real cosI = std::sqrt(1 - (1 - cosO * cosO) / (eta * eta));
        EXPECT_NEAR(fresnelDielectric(cosO, eta), fresnelDielectric(cosI, 1 / eta), 1e-10);
    }
}

TEST(Fresnel, ConductorAgreesWithComplexNumbers) {
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        Random random(3, {i});
        const Color eta(random.uniform(0.02, 4), random.uniform(0.02, 4), random.uniform(0.3, 3));
        const Color k(random.uniform(0, 5), random.uniform(0, 5), 0);  // the last one is a dielectric
        const Real cosO = random.uniform(1e-4, 1);
        const Color r = fresnelConductor(cosO, eta, k);
        EXPECT_NEAR(r.x(), referenceConductor(cosO, eta.x(), k.x()), 1e-10);
        EXPECT_NEAR(r.y(), referenceConductor(cosO, eta.y(), k.y()), 1e-10);
        EXPECT_NEAR(r.z(), fresnelDielectric(cosO, eta.z()), 1e-7);
    }
}

// Measured values of gold reflect red best, and Schlick's formula with a colour rises to white.
TEST(Fresnel, SchlicksColourRisesToWhite) {
    const Color gold = fresnelConductor(1, Metal::gold().eta, Metal::gold().k);
    EXPECT_TRUE((schlick(1, gold) == gold).all());
    EXPECT_TRUE((schlick(0, gold) == 1).all());
    EXPECT_GT(gold.x(), gold.y());
    EXPECT_GT(gold.y(), gold.z());
}

// Ray tracing through a pane, all reflections within followed: T = (1 − R)/(1 + R).
TEST(Dielectric, APaneLetsThroughTheSumOfAllReflections) {
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    for (const Real ior : {1.1, 1.5, 2.4, 0.7}) {
        const Scene pane(paneScene(std::make_shared<DielectricMaterial>(), ior));
        const RayTracer tracer(pane, sampler, filter, {.maxDepth = 1000, .leastWeight = 1e-12});
        RayCounts counts;
        const Real through = tracer.Li({Vec3(-1, 0, 0), Vec3::UnitX()}, {}, sampler.start(0, {0, 0}, 0), counts).x();
        const Real r = fresnelDielectric(1, ior);
        EXPECT_NEAR(through, (1 - r) / (1 + r), 1e-9) << "index " << ior;
    }
}

// Three ways to the light that rough gold gives back: over slopes, over directions, by samples of three kinds.
TEST(RoughConductor, AlbedoIsThatOfTheReference) {
    const Metal gold = Metal::gold();
    for (const Real alpha : {0.2, 0.7}) {
        for (const Real cosO : {0.95, 0.4}) {
            const Real truth = referenceAlbedo(cosO, gold.eta.y(), gold.k.y(), alpha);
            const RoughConductorBsdf metal({}, gold, Ggx(alpha, alpha));
            const Vec3 wo(std::sqrt(1 - cosO * cosO), 0, cosO);
            EXPECT_NEAR(test::albedo(metal, {}, wo, 1e-4).y(), truth, 5e-4);
            const Furnace furnace(gold, alpha, alpha, cosO);
            for (const DirectionChoice choice :
                 {DirectionChoice::VisibleNormals, DirectionChoice::AllNormals, DirectionChoice::Cosine}) {
                Real sum = 0;
                Real squares = 0;
                for (std::uint64_t round = 0; round < 100; ++round) {
                    const Real mean = furnace.estimate(choice, 1000, 4, round);
                    sum += mean / 100;
                    squares += mean * mean / 100;
                }
                const Real error = std::sqrt(std::max(0.0, squares - sum * sum) / 100);
                EXPECT_NEAR(sum, truth, 5.5 * error + 5e-4) << nameOf(choice);
            }
        }
    }
}

}  // namespace
}  // namespace caustic
