#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/random.h"
#include "material/dielectric_bsdf.h"
#include "material/directions.h"
#include "material/mirror_bsdf.h"
#include "material/phong_bsdf.h"
#include "material/refraction_bsdf.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_dielectric_bsdf.h"
#include "sampling/warp.h"
#include "support/bsdf_cases.h"
#include "support/bsdf_checks.h"
#include "support/direction_chi_square.h"

namespace caustic {
namespace {

constexpr double falseAlarm = 1e-6;

Vec3 anyDirection(Random& random) {
    const Real x = random.uniform();
    return uniformSphere({x, random.uniform()});
}

std::vector<test::BsdfCase> roughCases() {
    std::vector<test::BsdfCase> all = test::roughConductorCases();
    for (const Real ior : {0.6, 1.1, 1.5, 2.4})
        for (const test::BsdfCase& one : test::roughDielectricCases(ior)) all.push_back(one);
    return all;
}

std::vector<test::BsdfCase> allCases() {
    std::vector<test::BsdfCase> all = roughCases();
    for (const test::BsdfCase& one : test::earlierBsdfCases()) all.push_back(one);
    return all;
}

void expectTheDensity(const std::vector<test::BsdfCase>& cases, int samples) {
    std::uint64_t seed = 0;
    for (const test::BsdfCase& one : cases)
        EXPECT_GT(test::bsdfProbability(*one.bsdf, one.shading, one.wo, samples, ++seed), falseAlarm) << one.name;
}

// 504 cases in all. What so many samples see is said below; large_bsdf.cpp takes ten times as many.
TEST(BsdfDensity, EarlierModels) { expectTheDensity(test::earlierBsdfCases(), 60'000); }
TEST(BsdfDensity, RoughConductors) { expectTheDensity(test::roughConductorCases(), 60'000); }
TEST(BsdfDensity, RoughBubbles) { expectTheDensity(test::roughDielectricCases(0.6), 60'000); }
TEST(BsdfDensity, RoughOil) { expectTheDensity(test::roughDielectricCases(1.1), 60'000); }
TEST(BsdfDensity, RoughGlass) { expectTheDensity(test::roughDielectricCases(1.5), 60'000); }
TEST(BsdfDensity, RoughDiamond) { expectTheDensity(test::roughDielectricCases(2.4), 60'000); }

// The power: a density that is too large by 10 percent in one octant. 3 percent need ten times the samples:
// large_bsdf.cpp.
TEST(BsdfDensity, AnOctantWrongByTenPercentIsSeen) {
    Random random(1, {});
    const ShadingFrame shading = test::anyPlace(random, false, 1.5);
    const RoughDielectricBsdf glass(shading, Ggx(0.5, 0.5));
    const Vec3 wo = shading.frame.toWorld(Vec3(0.02, 0.03, 1).normalized());
    // What is reflected, into the other four, is a few percent of the light: too few samples to tell.
    for (int octant = 4; octant < 8; ++octant) {
        const auto wrong = [&](const Vec3& wi) {
            const Vec3 local = shading.frame.toLocal(wi);
            const int in = (local.x() < 0 ? 1 : 0) + (local.y() < 0 ? 2 : 0) + (local.z() < 0 ? 4 : 0);
            return glass.pdfW(wo, wi) * (in == octant ? 1.1 : 1);
        };
        const test::DirectionSampling sampling = {[&](const Vec2& u, Real uLobe) -> std::optional<Vec3> {
                                                      const auto sample =
                                                          glass.sample(wo, u, uLobe, TransportMode::Radiance);
                                                      if (!sample) return std::nullopt;
                                                      return sample->wi;
                                                  },
                                                  wrong};
        const Frame axes = {shading.frame.n, shading.frame.s, shading.frame.t};
        EXPECT_LT(test::directionProbability(sampling, 60'000, 3, axes), falseAlarm) << octant;
    }
}

TEST(BsdfSample, SaysWhatFAndPdfSay) {
    for (const test::BsdfCase& one : roughCases()) {
        for (std::uint64_t i = 0; i < 200; ++i) {
            Random random(2, {i});
            const Real x = random.uniform();
            const Vec2 u(x, random.uniform());
            const Real uLobe = random.uniform();
            for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
                const auto sample = one.bsdf->sample(one.wo, u, uLobe, mode);
                if (!sample) continue;
                EXPECT_NEAR(sample->wi.norm(), 1, 1e-12);
                EXPECT_GT(sample->pdfW, 0);
                EXPECT_NEAR(sample->pdfW, one.bsdf->pdfW(one.wo, sample->wi), 1e-9 * sample->pdfW) << one.name;
                EXPECT_LE((sample->f - one.bsdf->f(one.wo, sample->wi, mode)).abs().maxCoeff(),
                          1e-9 * sample->f.maxCoeff());
                const bool crosses = sample->wi.dot(one.shading.ng) * one.wo.dot(one.shading.ng) < 0;
                EXPECT_EQ(sample->transmits(), crosses) << one.name;
            }
        }
    }
}

// Energy. Every single weight of a sample of visible normals is a share.
TEST(BsdfEnergy, VisibleNormalsWeighAtMostOne) {
    for (const test::BsdfCase& one : roughCases())
        EXPECT_LE(test::largestWeight(*one.bsdf, one.shading, one.wo, 2000, 1), 1 + 1e-12) << one.name;
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random random(3, {i});
        const ShadingFrame shading = test::anyPlace(random, i % 2 == 1, random.uniform(0.3, 3));
        const Real alphaX = std::pow(10, random.uniform(-4, 0));
        const Real alphaY = std::pow(10, random.uniform(-4, 0));
        const Vec3 wo = anyDirection(random);
        const RoughDielectricBsdf glass(shading, Ggx(alphaX, alphaY));
        const RoughConductorBsdf metal(shading, Metal::silver(), Ggx(alphaX, alphaY));
        EXPECT_LE(test::largestWeight(glass, shading, wo, 200, i), 1 + 1e-12);
        EXPECT_LE(test::largestWeight(metal, shading, wo, 200, i), 1 + 1e-12);
    }
}

// The others by quadrature. Importance apart from ng isn't energy, so ns = ng.
TEST(BsdfEnergy, TheRestGivesBackAtMostWhatItGets) {
    for (const test::BsdfCase& one : test::earlierBsdfCases()) {
        if (one.shading.ng != one.shading.frame.n) continue;
        EXPECT_LE(test::albedo(*one.bsdf, one.shading, one.wo, 1e-5).maxCoeff(), 1 + 1e-4) << one.name;
    }
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(4, {i});
        const ShadingFrame shading = test::anyPlace(random, i % 2 == 1, random.uniform(0.3, 3));
        const Vec3 wo = anyDirection(random);
        const MirrorBsdf mirror(shading, Color::Ones());
        const DielectricBsdf glass(shading);
        const RefractionBsdf refraction(shading, Color::Constant(0.3), Color::Constant(0.7));
        for (const Bsdf* const bsdf : {static_cast<const Bsdf*>(&mirror), static_cast<const Bsdf*>(&glass),
                                       static_cast<const Bsdf*>(&refraction)}) {
            EXPECT_LE(test::largestWeight(*bsdf, shading, wo, 8, i), 1 + 1e-12);
            Color sum = Color::Zero();
            for (const BsdfSample& lobe : bsdf->deltaLobes(wo, TransportMode::Radiance))
                sum += lobe.f * lobe.eta * lobe.eta;
            EXPECT_LE(sum.maxCoeff(), 1 + 1e-12);
        }
    }
}

// Two ways to the same share: the mean weight of samples, and f by quadrature.
TEST(BsdfEnergy, SamplesAndQuadratureAgree) {
    for (const test::BsdfCase& one : allCases()) {
        if (one.shading.ng != one.shading.frame.n || one.name.find("0.02") != std::string::npos) continue;
        constexpr int n = 4000;
        Real sum = 0;
        Real squares = 0;
        for (int i = 0; i < n; ++i) {
            Random random(5, {static_cast<std::uint64_t>(i)});
            const Real x = random.uniform();
            const Real y = random.uniform();
            const auto sample = one.bsdf->sample(one.wo, {x, y}, random.uniform(), TransportMode::Importance);
            if (!sample) continue;
            const Real weight = sample->f.x() * one.bsdf->cosine(sample->wi) / sample->pdfW;
            sum += weight;
            squares += weight * weight;
        }
        const Real mean = sum / n;
        const Real error = std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
        const Real truth = test::albedo(*one.bsdf, one.shading, one.wo, 1e-3).x();
        EXPECT_NEAR(mean, truth, 4.9 * error + 2e-3) << one.name;
    }
}

TEST(BsdfReciprocity, HoldsForEveryModel) {
    int compared = 0;
    for (const test::BsdfCase& one : allCases()) {
        if (one.shading.ng != one.shading.frame.n) continue;
        for (std::uint64_t i = 0; i < 100; ++i) {
            Random random(6, {i});
            const Vec3 a = anyDirection(random);
            // Half of the pairs are what light really does; two directions at random meet no narrow lobe.
            const auto sample = one.bsdf->sample(a, {random.uniform(), 0.3}, 0.9, TransportMode::Radiance);
            const Vec3 b = i % 2 == 0 || !sample ? anyDirection(random) : sample->wi;
            EXPECT_LE(test::reciprocityError(*one.bsdf, one.shading, a, b), 1e-9) << one.name << ", pair " << i;
            ++compared;
        }
    }
    EXPECT_GT(compared, 20'000);
}

// Veach 5.3: with f* the importance version, f*(a, b) |a·ng| |b·ns| = f(b, a) |b·ng| |a·ns|, through a boundary, too.
TEST(BsdfReciprocity, ImportanceIsTheAdjointWithShadingNormals) {
    int compared = 0;
    for (const test::BsdfCase& one : roughCases()) {
        if (one.shading.ng == one.shading.frame.n) continue;
        for (std::uint64_t i = 0; i < 50; ++i) {
            Random random(7, {i});
            const Vec3 a = anyDirection(random);
            const Vec3 b = anyDirection(random);
            const Vec3& ns = one.shading.frame.n;
            const Vec3& ng = one.shading.ng;
            const Real forth = one.bsdf->f(a, b, TransportMode::Importance).x() * std::abs(a.dot(ng) * b.dot(ns));
            const Real back = one.bsdf->f(b, a, TransportMode::Radiance).x() * std::abs(b.dot(ng) * a.dot(ns));
            if (forth == 0 || back == 0) continue;  // one of the two sees the other from behind its normal
            EXPECT_NEAR(forth, back, 1e-9 * std::max(forth, back)) << one.name;
            ++compared;
        }
    }
    EXPECT_GT(compared, 2000);
}

}  // namespace
}  // namespace caustic
