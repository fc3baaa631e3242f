#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "material/directions.h"
#include "material/fresnel.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_dielectric_bsdf.h"
#include "sampling/warp.h"
#include "support/sphere_integral.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

// Seen and lit from straight above, nothing is hidden and only facets that lie flat count: f = F D/4 = F/(4π α²).
// Aslant those count that lie half-way, as far as they are seen.
TEST(RoughConductor, FromAboveOnlyFlatFacetsCount) {
    const Metal gold = Metal::gold();
    for (const Real alpha : {0.05, 0.3, 1.0}) {
        const RoughConductorBsdf metal({}, gold, Ggx(alpha, alpha));
        const Color f = metal.f(Vec3::UnitZ(), Vec3::UnitZ(), TransportMode::Radiance);
        const Color expected = fresnelConductor(1, gold.eta, gold.k) / (4 * pi * alpha * alpha);
        EXPECT_LE((f / expected - 1).abs().maxCoeff(), 1e-9) << "Which factor comes from half-way directions?";
    }
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Ggx facets(random.uniform(0.1, 1), random.uniform(0.1, 1));
        const RoughConductorBsdf metal({}, gold, facets);
        const Real x = random.uniform();
        const Vec3 wo = cosineHemisphere({x, random.uniform()});
        const Real y = random.uniform();
        const Vec3 wi = cosineHemisphere({y, random.uniform()});
        // Half-way: cos² of the angle between wo and the facet is (1 + wo · wi)/2.
        const Color F = fresnelConductor(std::sqrt((1 + wo.dot(wi)) / 2), gold.eta, gold.k);
        const Real DG = facets.D((wo + wi).normalized()) * facets.reflectionG(wo, wi);
        const Color f = metal.f(wo, wi, TransportMode::Radiance);
        EXPECT_LE((f * (4 * wo.z() * wi.z()) / (F * DG) - 1).abs().maxCoeff(), 1e-9)
            << "Which facets, and what of them is seen from both sides?";
    }
}

// f(wo, wi) = f(wi, wo), and nothing goes through.
TEST(RoughConductor, IsReciprocalAndOpaque) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(1, {i});
        const Ggx facets(random.uniform(0.1, 1), random.uniform(0.1, 1));
        const RoughConductorBsdf metal({}, Metal::copper(), facets);
        const Real x = random.uniform();
        const Vec3 wo = cosineHemisphere({x, random.uniform()});
        const Real y = random.uniform();
        const Vec3 wi = cosineHemisphere({y, random.uniform()});
        const Color forth = metal.f(wo, wi, TransportMode::Radiance);
        const Color back = metal.f(wi, wo, TransportMode::Radiance);
        EXPECT_LE((forth - back).abs().maxCoeff(), 1e-9 * forth.maxCoeff())
            << "Which angle do Fresnel's equations ask for? Which cosines is it divided by?";
        EXPECT_TRUE((metal.f(wo, -wi, TransportMode::Radiance) == 0).all()) << "Through metal?";
        EXPECT_TRUE((metal.f(-wo, wi, TransportMode::Radiance) == 0).all()) << "Through metal?";
    }
    const RoughConductorBsdf flat({}, Metal::gold(), Ggx(0.3, 0.3));
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(-1, 0, 0)}) {
        EXPECT_TRUE((flat.f(Vec3::UnitZ(), along, TransportMode::Radiance) == 0).all()) << "Divided by a cosine of 0?";
        EXPECT_TRUE((flat.f(along, Vec3::UnitZ(), TransportMode::Radiance) == 0).all()) << "Divided by a cosine of 0?";
    }
}

// The density of what is refracted sums up to the share of light that is: seen from above,
// ∫ pdfW over the lower half = mean of 1 − F over the facets that refract downwards.
TEST(RoughGlass, DensityCountsTheSolidAngleOfNormals) {
    for (const Real ior : {1.3, 1.8, 2.4}) {
        for (const Real alpha : {0.2, 0.6}) {
            ShadingFrame shading;
            shading.iorBelow = ior;
            const Ggx facets(alpha, alpha);
            const RoughDielectricBsdf glass(shading, facets);
            const Real density =
                test::hemisphereIntegral([&](const Vec3& wi) { return glass.pdfW(Vec3::UnitZ(), wi); }, -1);
            // Seen from above all facets count by D(wm) wm.z. Refraction never turns light back up.
            const Real share = test::hemisphereIntegral(
                [&](const Vec3& wm) { return (1 - fresnelDielectric(wm.z(), ior)) * facets.D(wm) * wm.z(); }, 0);
            EXPECT_NEAR(density, share, 1e-4)
                << "index " << ior << ", roughness " << alpha << ": How do directions spread when normals do?";
        }
    }
    // Aslant and from both sides. The facet's normal is along wo + η wi, whose length squared is the denominator.
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        ShadingFrame shading;
        shading.iorBelow = random.uniform(1.2, 2.4);
        const Ggx facets(random.uniform(0.2, 1), random.uniform(0.2, 1));
        const RoughDielectricBsdf glass(shading, facets);
        const Real side = i % 2 == 0 ? 1 : -1;
        const Real eta = side > 0 ? shading.iorBelow : 1 / shading.iorBelow;
        const Real x = random.uniform();
        const Vec3 wo = cosineHemisphere({x, random.uniform()});  // as facets see it
        const Real y = random.uniform();
        const Vec3 wm = facets.sampleVisible(wo, {y, random.uniform()});
        const auto wi = refracted(wo, wm, eta);
        if (!wi || wi->z() >= -1e-3) continue;
        const Real through = 1 - fresnelDielectric(std::min(wo.dot(wm), Real(1)), eta);
        const Real spread = eta * eta * std::abs(wi->dot(wm)) / (wo + eta * *wi).squaredNorm();
        const auto seen = [&](const Vec3& local) { return Vec3(local.x(), local.y(), side * local.z()); };
        EXPECT_NEAR(glass.pdfW(seen(wo), seen(*wi)) / (through * facets.pdfVisible(wo, wm) * spread), 1, 1e-7)
            << "Which indices, and on which side?";
    }
    // Straight through, to the last digits.
    ShadingFrame shading;
    shading.iorBelow = 1.3;
    const Ggx facets(0.3, 0.4);
    const RoughDielectricBsdf glass(shading, facets);
    const Real through = 1 - std::pow(0.3 / 2.3, 2);
    const Real straight = through * facets.D(Vec3::UnitZ()) * std::pow(1.3 / 0.3, 2);
    EXPECT_NEAR(glass.pdfW(Vec3::UnitZ(), -Vec3::UnitZ()) / straight, 1, 1e-12) << "Straight through?";
}

}  // namespace
}  // namespace caustic
