#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"
#include "material/fresnel.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_dielectric_bsdf.h"
#include "sampling/warp.h"
#include "support/sphere_integral.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

// Seen and lit from straight above, nothing is hidden and only facets that lie flat count: f = F D/4 = F/(4π α²).
TEST(RoughConductor, FromAboveOnlyFlatFacetsCount) {
    const Metal gold = Metal::gold();
    for (const Real alpha : {0.05, 0.3, 1.0}) {
        const RoughConductorBsdf metal({}, gold, Ggx(alpha, alpha));
        const Color f = metal.f(Vec3::UnitZ(), Vec3::UnitZ(), TransportMode::Radiance);
        const Color expected = fresnelConductor(1, gold.eta, gold.k) / (4 * pi * alpha * alpha);
        EXPECT_LE((f / expected - 1).abs().maxCoeff(), 1e-9) << "Which factor comes from half-way directions?";
    }
}

// f(wo, wi) = f(wi, wo), and nothing goes through.
TEST(RoughConductor, IsReciprocalAndOpaque) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(1, {i});
        const RoughConductorBsdf metal({}, Metal::copper(), Ggx(random.uniform(0.1, 1), random.uniform(0.1, 1)));
        const Real x = random.uniform();
        const Vec3 wo = cosineHemisphere({x, random.uniform()});
        const Real y = random.uniform();
        const Vec3 wi = cosineHemisphere({y, random.uniform()});
        const Color forth = metal.f(wo, wi, TransportMode::Radiance);
        const Color back = metal.f(wi, wo, TransportMode::Radiance);
        EXPECT_LE((forth - back).abs().maxCoeff(), 1e-9 * forth.maxCoeff())
            << "Which angle do Fresnel's equations ask for? Which cosines is it divided by?";
        EXPECT_TRUE((metal.f(wo, -wi, TransportMode::Radiance) == 0).all()) << "Through metal?";
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
}

}  // namespace
}  // namespace caustic
