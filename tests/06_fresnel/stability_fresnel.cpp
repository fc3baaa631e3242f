#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "camera/box_filter.h"
#include "core/error.h"
#include "core/random.h"
#include "figures.h"
#include "figures/glossy_tracer.h"
#include "integrator/render.h"
#include "material/conductor_bsdf.h"
#include "material/conductor_material.h"
#include "material/dielectric_bsdf.h"
#include "material/fresnel.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_conductor_material.h"
#include "material/rough_dielectric_bsdf.h"
#include "material/rough_dielectric_material.h"
#include "sampling/independent_sampler.h"
#include "sampling/warp.h"
#include "scenes.h"
#include "support/bsdf_cases.h"
#include "support/failure_checks.h"

namespace caustic {
namespace {

constexpr Real infinite = std::numeric_limits<Real>::infinity();
constexpr Real notANumber = std::numeric_limits<Real>::quiet_NaN();

// What failure.csv counts, with another seed than the chart's.
TEST(Failures, TheCoursesMethodsHaveNoneWhereOthersFail) {
    const auto rows = failureRows({1000, 77, 2});
    EXPECT_EQ(rows.size(), 14U);
    test::expectOnlyFragileMethodsFail(rows, 0.05);
}

// Angles down to along the surface, indices far from 1 and close to it, around the critical angle.
TEST(Fresnel, IsAShareAtEveryAngleAndIndex) {
    for (std::uint64_t i = 0; i < 200'000; ++i) {
        Random random(1, {i});
        const Real eta = i % 2 == 0 ? std::pow(10, random.uniform(-2, 2)) : 1 + std::pow(10, random.uniform(-17, -1));
        const Real critical = eta < 1 ? std::sqrt(1 - eta * eta) : 0;
        const Real cosines[] = {0, 1, std::pow(10, random.uniform(-300, 0)),
                                std::min(Real(1), critical * (1 + std::pow(10, random.uniform(-17, -3)))),
                                critical * (1 - std::pow(10, random.uniform(-17, -3)))};
        const Color k = Color::Constant(i % 3 == 0 ? 0 : std::pow(10, random.uniform(-6, 2)));
        for (const Real cosO : cosines) {
            const Real exact = fresnelDielectric(cosO, eta);
            EXPECT_TRUE(exact >= 0 && exact <= 1) << cosO << ", " << eta << ": " << exact;
            const Real approximate = schlick(cosO, eta);
            EXPECT_TRUE(approximate >= 0 && approximate <= 1 + 1e-15) << cosO << ", " << eta << ": " << approximate;
            const Color metal = fresnelConductor(cosO, Color::Constant(eta), k);
            EXPECT_TRUE((metal >= -1e-12).all() && (metal <= 1 + 1e-12).all()) << cosO << ", " << eta << ", " << k.x();
        }
    }
}

// No jump at the critical angle: R = 1 − 4 x (1/η + η) … to first order in x = √(c² − c₀²)/η, so a step of 1e-8 in the
// cosine moves R by less than 1e-2.
TEST(Fresnel, IsContinuousAtTheCriticalAngle) {
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        const Real eta = Random(2, {i}).uniform(0.3, 0.95);
        const Real critical = std::sqrt(1 - eta * eta);
        Real before = 1;
        for (const Real past : {0.0, 1e-12, 1e-10, 1e-9, 1e-8}) {
            const Real here = fresnelDielectric(critical + past, eta);
            EXPECT_LE(here, before + 1e-12);
            EXPECT_GT(here, 1 - 200 * std::sqrt(past + 1e-15));
            before = here;
        }
    }
}

template <typename Check>
void forExtremeModels(const Check& check) {
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        Random random(3, {i});
        const Real ior =
            random.below(2) ? std::pow(10, random.uniform(-1, 1)) : 1 + std::pow(10, random.uniform(-4, -1));
        const ShadingFrame shading = test::anyPlace(random, random.below(2) == 1, ior);
        const Real alphaX = random.below(4) ? std::pow(10, random.uniform(-6, 0)) : 1;
        const Real alphaY = random.below(4) ? std::pow(10, random.uniform(-6, 0)) : 0;
        const Metal metal = {Color::Constant(std::pow(10, random.uniform(-3, 1))),
                             Color::Constant(std::pow(10, random.uniform(-3, 2)))};
        check(ConductorBsdf(shading, metal), shading, random);
        check(DielectricBsdf(shading), shading, random);
        check(RoughConductorBsdf(shading, metal, Ggx(alphaX, alphaY)), shading, random);
        check(RoughDielectricBsdf(shading, Ggx(alphaX, alphaY)), shading, random);
    }
}

// Directions anywhere, along the surface among them, and numbers at the ends of [0, 1).
TEST(Bsdf, SamplesAreFiniteAndOnTheirSide) {
    forExtremeModels([](const Bsdf& bsdf, const ShadingFrame& shading, Random& random) {
        const Frame axes = Frame::around(shading.ng);
        const Real sine = std::sqrt(random.uniform());
        const Real cosO = random.below(2) ? std::sqrt(1 - sine * sine) : std::pow(10, random.uniform(-12, 0));
        const Real turn = random.uniform(0, 6.3);
        const Real r = std::sqrt(1 - cosO * cosO);
        const Vec3 wo = axes.toWorld({r * std::cos(turn), r * std::sin(turn), random.below(2) ? cosO : -cosO});
        const Real last = 1 - 0x1p-53;
        const Real numbers[] = {0, last, random.uniform()};
        const Vec2 u(numbers[random.below(3)], numbers[random.below(3)]);
        for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
            const auto sample = bsdf.sample(wo, u, numbers[random.below(3)], mode);
            if (!sample) continue;
            EXPECT_TRUE(sample->f.allFinite() && (sample->f >= 0).all());
            EXPECT_TRUE(std::isfinite(sample->pdfW) && sample->pdfW > 0);
            EXPECT_NEAR(sample->wi.norm(), 1, 1e-9);
            EXPECT_EQ(sample->transmits(), shading.side(sample->wi) != shading.side(wo));
        }
        const Real x = random.uniform();
        const Vec3 wi = uniformSphere({x, random.uniform()});
        EXPECT_TRUE(bsdf.f(wo, wi, TransportMode::Importance).allFinite());
        EXPECT_TRUE(std::isfinite(bsdf.pdfW(wo, wi)));
    });
}

// Where the indices are alike, a boundary isn't there, however rough it is.
TEST(RoughDielectricMaterial, IndexOneIsNotThere) {
    const RoughDielectricMaterial rough(0.5, 0.5);
    BsdfBuffer bsdf;
    rough.build({}, {}, bsdf);
    for (const Real cosO : {1.0, 0.3, 1e-3}) {
        const Vec3 wo(std::sqrt(1 - cosO * cosO), 0, cosO);
        const DeltaLobes lobes = bsdf.get()->deltaLobes(wo, TransportMode::Radiance);
        ASSERT_EQ(lobes.count, 1);
        EXPECT_LE((lobes.lobe[0].wi + wo).norm(), 1e-12);
        EXPECT_EQ(lobes.lobe[0].f.x(), 1);
    }
    EXPECT_TRUE(anyOf(rough.lobes(), LobeFlags::Delta)) << "whoever looks for delta lobes must find these";
}

TEST(ConductorMaterial, MetalUnderWaterReflectsLess) {
    ShadingFrame water;
    water.iorAbove = water.iorBelow = 1.33;
    BsdfBuffer inAir;
    BsdfBuffer inWater;
    const ConductorMaterial gold(Metal::gold());
    gold.build({}, {}, inAir);
    gold.build({}, water, inWater);
    const Color dry = inAir.get()->deltaLobes(Vec3::UnitZ(), TransportMode::Radiance).lobe[0].f;
    const Color wet = inWater.get()->deltaLobes(Vec3::UnitZ(), TransportMode::Radiance).lobe[0].f;
    EXPECT_TRUE((wet < dry).all());
    EXPECT_LT(wet.z() / wet.x(), dry.z() / dry.x()) << "redder";
}

// The pictures' own way: nothing is not a number, and threads don't matter.
TEST(GlossyTracer, RendersTheSameWithAnyThreadsAndNothingBad) {
    for (const bool glass : {false, true}) {
        std::shared_ptr<const Material> material = std::make_shared<RoughConductorMaterial>(Metal::gold(), 0.3, 0.03);
        if (glass) material = std::make_shared<RoughDielectricMaterial>(0.2, 0.2);
        const Scene scene(ballScene(material, glass, 40, 30));
        const IndependentSampler sampler(5);
        const BoxFilter filter;
        GlossyTracer tracer(scene, sampler, filter, 12);
        const Rendering one = render(tracer, {.passes = 16});
        const Rendering two = render(tracer, {.passes = 16, .threads = 2});
        EXPECT_FALSE(one.film.firstBad());
        const Image first = one.film.image();
        const Image second = two.film.image();
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x) ASSERT_TRUE((first.at(x, y) == second.at(x, y)).all());
    }
}

TEST(BadInput, MetalsAndRoughness) {
    const auto metal = [](Real eta, Real k) { return Metal{Color::Constant(eta), Color::Constant(k)}; };
    for (const Real eta : {0.0, -1.0, infinite, notANumber}) {
        EXPECT_THROW(ConductorMaterial{metal(eta, 1)}, InputError);
        EXPECT_THROW(RoughConductorMaterial(metal(eta, 1), 0.1, 0.1), InputError);
    }
    for (const Real k : {-1.0, infinite, notANumber}) EXPECT_THROW(ConductorMaterial{metal(1, k)}, InputError);
    for (const Real alpha : {-0.1, 1.1, infinite, notANumber}) {
        EXPECT_THROW(RoughConductorMaterial(Metal::gold(), alpha, 0.1), InputError);
        EXPECT_THROW(RoughConductorMaterial(Metal::gold(), 0.1, alpha), InputError);
        EXPECT_THROW(RoughDielectricMaterial(alpha, 0.1), InputError);
        EXPECT_THROW(RoughDielectricMaterial(0.1, alpha), InputError);
    }
    try {
        RoughDielectricMaterial(1.5, 0.1);
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("roughness"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("1.5"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace caustic
