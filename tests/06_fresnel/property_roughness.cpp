#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "material/conductor_material.h"
#include "material/dielectric_bsdf.h"
#include "material/directions.h"
#include "material/fresnel.h"
#include "material/phong_bsdf.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_conductor_material.h"
#include "material/rough_dielectric_bsdf.h"
#include "material/rough_dielectric_material.h"
#include "support/bsdf_checks.h"
#include "support/direction_chi_square.h"

namespace caustic {
namespace {

// Facets that flatten: mean of a smooth function of the sampled direction against the one direction of the mirror and
// of smooth glass. Halving the roughness halves the difference at least.
struct Limit {
    Real alpha;
    Real difference;
};

Color meanOver(const Bsdf& bsdf, const Vec3& wo) {
    constexpr int perAxis = 128;
    Color sum = Color::Zero();
    for (int i = 0; i < perAxis * perAxis * 8; ++i) {
        const Vec2 u((i % perAxis + 0.5) / perAxis, (i / perAxis % perAxis + 0.5) / perAxis);
        const Real uLobe = (i / (perAxis * perAxis) + 0.5) / 8;
        const auto sample = bsdf.sample(wo, u, uLobe, TransportMode::Importance);
        if (!sample) continue;
        const Real seen = 1 + 0.5 * sample->wi.x() + 0.3 * sample->wi.z() + 0.2 * sample->wi.y() * sample->wi.y();
        sum += sample->f * (sample->delta() ? 1 : bsdf.cosine(sample->wi)) / sample->pdfW * seen;
    }
    return sum / (perAxis * perAxis * 8);
}

Color meanOverLobes(const Bsdf& bsdf, const Vec3& wo) {
    Color sum = Color::Zero();
    for (const BsdfSample& lobe : bsdf.deltaLobes(wo, TransportMode::Importance))
        sum += lobe.f * (1 + 0.5 * lobe.wi.x() + 0.3 * lobe.wi.z() + 0.2 * lobe.wi.y() * lobe.wi.y());
    return sum;
}

TEST(RoughnessToZero, MeetsTheMirror) {
    const ShadingFrame shading;
    const ConductorMaterial smooth(Metal::gold());
    BsdfBuffer mirror;
    smooth.build({}, shading, mirror);
    for (const Real cosine : {1.0, 0.7, 0.3}) {
        const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
        const Color truth = meanOverLobes(*mirror.get(), wo);
        for (const Real alpha : {3e-2, 1e-2, 3e-3, 1e-3, 1e-4}) {
            const RoughConductorBsdf rough(shading, Metal::gold(), Ggx(alpha, alpha));
            // The slopes' spread is α, their tail as α² log(1/α).
            EXPECT_LE((meanOver(rough, wo) - truth).abs().maxCoeff(), 20 * alpha * alpha * std::log(10 / alpha) + 1e-7)
                << "cosine " << cosine << ", alpha " << alpha;
        }
        BsdfBuffer below;
        RoughConductorMaterial(Metal::gold(), 0.99e-4, 0).build({}, shading, below);
        EXPECT_TRUE((meanOverLobes(*below.get(), wo) == truth).all()) << "smooth below Ggx::smoothBelow";
    }
}

TEST(RoughnessToZero, MeetsSmoothGlass) {
    for (const Real ior : {1.5, 1 / 1.5}) {
        ShadingFrame shading;
        shading.iorBelow = ior;
        const DielectricBsdf smooth(shading);
        for (const Real cosine : {1.0, 0.9}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
            // Shares are chosen by one of 8 numbers here: compare the shares' own values.
            for (const Real alpha : {1e-2, 1e-3, 1e-4}) {
                const RoughDielectricBsdf rough(shading, Ggx(alpha, alpha));
                for (const BsdfSample& lobe : smooth.deltaLobes(wo, TransportMode::Radiance)) {
                    const Real uLobe = lobe.transmits() ? 0.999 : 0;
                    const auto sample = rough.sample(wo, {0.3, 0.3}, uLobe, TransportMode::Radiance);
                    ASSERT_TRUE(sample);
                    EXPECT_LE((sample->wi - lobe.wi).norm(), 6 * alpha) << "alpha " << alpha;
                    const Real share =
                        lobe.transmits() ? 1 - fresnelDielectric(cosine, ior) : fresnelDielectric(cosine, ior);
                    const Real weight = sample->f.x() * rough.cosine(sample->wi) / sample->pdfW * share;
                    EXPECT_NEAR(weight, lobe.f.x(), 5 * alpha) << "alpha " << alpha;
                }
            }
        }
        BsdfBuffer below;
        RoughDielectricMaterial(0, 0).build({}, shading, below);
        EXPECT_NE(dynamic_cast<const DielectricBsdf*>(below.get()), nullptr);
    }
}

// Of single scattering nothing is known but Smith's model itself: facets at random heights, seen by whoever is not
// hidden. This walks that model: a height, a facet, one event, out or not.
TEST(RoughDielectric, SingleScatteringIsThatOfRandomFacets) {
    ShadingFrame shading;
    shading.iorBelow = 1.5;
    for (const Real alpha : {0.3, 0.8}) {
        const Ggx facets(alpha, alpha);
        const RoughDielectricBsdf glass(shading, facets);
        for (const Real cosine : {0.9, 0.4}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
            constexpr int n = 200'000;
            Real reflectedShare = 0;
            Real throughShare = 0;
            for (int i = 0; i < n; ++i) {
                Random random(8, {static_cast<std::uint64_t>(i)});
                const Vec3 wm = facets.sampleVisible(wo, {random.uniform(), random.uniform()});
                // A height that wo sees: h^Λ of all of that height are seen.
                const Real height = std::pow(random.uniform(), 1 / (1 + facets.lambda(wo)));
                const Real r = fresnelDielectric(wo.dot(wm), 1.5);
                const Vec3 up = reflected(wo, wm);
                if (up.z() > 0) reflectedShare += r * std::pow(height, facets.lambda(up)) / n;
                const auto down = refracted(wo, wm, 1.5);
                if (down && down->z() < 0) throughShare += (1 - r) * std::pow(1 - height, facets.lambda(*down)) / n;
            }
            const Real all = test::albedo(glass, shading, wo, 1e-4).x();
            EXPECT_NEAR(all, reflectedShare + throughShare, 4.9 * 0.5 / std::sqrt(n) + 1e-4)
                << "alpha " << alpha << ", cosine " << cosine;
        }
    }
}

}  // namespace
}  // namespace caustic
