#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "light/area_light.h"
#include "light/constant_environment.h"
#include "material/bsdf_buffer.h"
#include "material/diffuse_bsdf.h"
#include "material/directions.h"
#include "material/mirror_bsdf.h"
#include "material/phong_bsdf.h"
#include "material/refraction_bsdf.h"
#include "sampling/warp.h"
#include "support/direction_chi_square.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr double falseAlarm = 1e-6;

Vec3 randomDirection(Random& random) {
    const Real x = random.uniform();
    return uniformSphere({x, random.uniform()});
}

// A place with ns = ng, or with ns turned away from it by a quarter of a radian.
ShadingFrame place(std::uint64_t seed, bool smooth, Real iorBelow = 1) {
    Random random(seed, {});
    ShadingFrame shading;
    shading.ng = randomDirection(random);
    const Frame around = Frame::around(shading.ng);
    const Vec3 ns = smooth ? (std::cos(0.25) * around.n + std::sin(0.25) * around.s).eval() : shading.ng;
    shading.frame = Frame::around(ns);
    shading.iorBelow = iorBelow;
    return shading;
}

std::vector<std::unique_ptr<Bsdf>> spreadModels(const ShadingFrame& shading) {
    std::vector<std::unique_ptr<Bsdf>> models;
    models.push_back(std::make_unique<DiffuseBsdf>(shading, Color(0.2, 0.5, 0.9)));
    models.push_back(std::make_unique<PhongBsdf>(shading, Color(0.2, 0.5, 0.1), Color(0.5, 0.5, 0.8), 20));
    models.push_back(std::make_unique<PhongBsdf>(shading, Color::Zero(), Color::Ones(), 1));
    models.push_back(std::make_unique<PhongBsdf>(shading, Color::Ones(), Color::Zero(), 5));
    return models;
}

TEST(Bsdf, SamplesHaveTheDensity) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const ShadingFrame shading = place(seed, seed % 2 == 1);
        Random random(1, {seed});
        const Vec3 wo = randomDirection(random);
        for (const auto& model : spreadModels(shading)) {
            const test::DirectionSampling sampling = {[&](const Vec2& u, Real uLobe) -> std::optional<Vec3> {
                                                          const auto sample =
                                                              model->sample(wo, u, uLobe, TransportMode::Radiance);
                                                          if (!sample) return std::nullopt;
                                                          return sample->wi;
                                                      },
                                                      [&](const Vec3& wi) { return model->pdfW(wo, wi); }};
            EXPECT_GT(test::directionProbability(sampling, 40'000, seed), falseAlarm) << "seed " << seed;
        }
    }
}

TEST(Bsdf, SampleSaysWhatFAndPdfSay) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const ShadingFrame shading = place(i, i % 2 == 1);
        Random random(2, {i});
        const Vec3 wo = randomDirection(random);
        const Real x = random.uniform();
        const Vec2 u(x, random.uniform());
        for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
            for (const auto& model : spreadModels(shading)) {
                const auto sample = model->sample(wo, u, random.uniform(), mode);
                if (!sample) continue;
                EXPECT_NEAR(sample->wi.norm(), 1, 1e-12);
                EXPECT_GT(sample->pdfW, 0);
                EXPECT_NEAR(sample->pdfW, model->pdfW(wo, sample->wi), 1e-9 * sample->pdfW);
                EXPECT_TRUE((sample->f - model->f(wo, sample->wi, mode)).abs().maxCoeff() <=
                            1e-9 * sample->f.maxCoeff());
                EXPECT_GT(sample->wi.dot(shading.ng) * wo.dot(shading.ng), 0) << "reflected to the other side";
            }
        }
    }
}

// Where ns = ng the value is the same both ways; and it is the same for both modes.
TEST(Bsdf, IsReciprocal) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const ShadingFrame shading = place(i, false);
        Random random(3, {i});
        const Vec3 a = randomDirection(random);
        const Vec3 b = randomDirection(random);
        for (const auto& model : spreadModels(shading)) {
            const Color forth = model->f(a, b, TransportMode::Radiance);
            EXPECT_LE((forth - model->f(b, a, TransportMode::Radiance)).abs().maxCoeff(),
                      1e-9 * (1 + forth.maxCoeff()));
            EXPECT_LE((forth - model->f(a, b, TransportMode::Importance)).abs().maxCoeff(),
                      1e-9 * (1 + forth.maxCoeff()));
        }
    }
}

// Veach 5.3: with f* the importance version, f*(a, b) |a·ng| |b·ns| = f(b, a) |b·ng| |a·ns|.
TEST(Bsdf, ImportanceIsTheAdjointWithShadingNormals) {
    int compared = 0;
    int towards = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const ShadingFrame shading = place(i, true);
        Random random(4, {i});
        const Vec3 a = randomDirection(random);
        const Vec3 b = randomDirection(random);
        const DiffuseBsdf model(shading, Color::Ones());
        const Vec3& ns = shading.frame.n;
        const Real forth = model.f(a, b, TransportMode::Importance).x() * std::abs(a.dot(shading.ng) * b.dot(ns));
        const Real back = model.f(b, a, TransportMode::Radiance).x() * std::abs(b.dot(shading.ng) * a.dot(ns));
        EXPECT_NEAR(forth, back, 1e-12);
        const auto disagree = [&](const Vec3& w) { return (w.dot(shading.ng) < 0) != (w.dot(ns) < 0); };
        if (disagree(a)) {
            EXPECT_EQ(forth, 0) << "no light is scattered from where the normals disagree";
        }
        compared += forth > 0 ? 1 : 0;
        towards += forth > 0 && disagree(b) ? 1 : 0;
    }
    EXPECT_GT(compared, 500);
    EXPECT_GT(towards, 20) << "but to there it is";
}

// ∫ f |cos| ≤ 1 by the midpoint rule over 400 × 200 directions.
TEST(Bsdf, MakesNoEnergy) {
    const ShadingFrame shading = place(1, false);
    for (const Real cosine : {1.0, 0.7, 0.3, 0.02}) {
        const Vec3 wo = shading.frame.toWorld({std::sqrt(1 - cosine * cosine), 0, cosine});
        for (const auto& model : spreadModels(shading)) {
            Color sum = Color::Zero();
            for (int i = 0; i < 400 * 200; ++i) {
                const Real z = 2 * (i / 400 + 0.5) / 200 - 1;
                const Real angle = 2 * pi * (i % 400 + 0.5) / 400;
                const Real r = std::sqrt(1 - z * z);
                const Vec3 wi = shading.frame.toWorld({r * std::cos(angle), r * std::sin(angle), z});
                sum += model->f(wo, wi, TransportMode::Radiance) * model->cosine(wi) * 4 * pi / (400 * 200);
            }
            EXPECT_LE(sum.maxCoeff(), 1 + 1e-3);
        }
    }
}

// The path through a boundary and back: the same direction, and the two scales of radiance cancel.
TEST(RefractionBsdf, WayBackLeadsBack) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(5, {i});
        const ShadingFrame shading = place(i, false, random.uniform(0.5, 2.5));
        const RefractionBsdf model(shading, Color::Constant(0.1), Color::Constant(0.9));
        const Vec3 wo = randomDirection(random);
        Real energy = 0;
        for (const BsdfSample& lobe : model.deltaLobes(wo, TransportMode::Radiance)) {
            energy += lobe.f.x() * lobe.eta * lobe.eta;
            if (!lobe.transmits()) {
                EXPECT_LE((lobe.wi - reflected(wo, shading.ng)).norm(), 1e-12);
                continue;
            }
            const Real side = shading.side(wo);
            EXPECT_NEAR(lobe.eta, side > 0 ? shading.iorBelow : 1 / shading.iorBelow, 1e-12);
            EXPECT_NEAR(wo.cross(shading.ng).norm(), lobe.eta * lobe.wi.cross(shading.ng).norm(), 1e-12) << "Snell";
            bool back = false;
            for (const BsdfSample& returned : model.deltaLobes(lobe.wi, TransportMode::Radiance)) {
                if (!returned.transmits()) continue;
                EXPECT_LE((returned.wi - wo).norm(), 1e-6);
                EXPECT_NEAR(returned.f.x() * lobe.f.x(), 0.81, 1e-12);
                back = true;
            }
            EXPECT_TRUE(back);
        }
        EXPECT_NEAR(energy, 1, 1e-12) << "all light goes somewhere, beyond the critical angle too";
    }
}

// Lobes are chosen with the probabilities that deltaLobes states.
TEST(RefractionBsdf, SampleChoosesAmongItsLobes) {
    const ShadingFrame shading = place(2, false, 1.5);
    const RefractionBsdf model(shading, Color::Constant(0.2), Color::Constant(0.6));
    const Vec3 wo = shading.frame.toWorld(Vec3(0.6, 0, 0.8));
    EXPECT_FALSE(model.sample(wo, {}, 0.2, TransportMode::Radiance)->transmits());
    EXPECT_TRUE(model.sample(wo, {}, 0.3, TransportMode::Radiance)->transmits());
    EXPECT_NEAR(model.sample(wo, {}, 0.3, TransportMode::Radiance)->pdfW, 0.75, 1e-12);
    EXPECT_NEAR(model.sample(wo, {}, 0.3, TransportMode::Importance)->f.x(), 0.6, 1e-12);
    EXPECT_NEAR(model.sample(wo, {}, 0.3, TransportMode::Radiance)->f.x(), 0.6 / 2.25, 1e-12);
}

TEST(BsdfBuffer, CopiesHoldTheirOwn) {
    const ShadingFrame shading = place(3, false);
    const Vec3 up = shading.ng;
    BsdfBuffer copy;
    EXPECT_EQ(copy.get(), nullptr);
    {
        BsdfBuffer original;
        original.emplace<DiffuseBsdf>(shading, Color(0.1, 0.2, 0.3));
        copy = original;
        original.emplace<MirrorBsdf>(shading, Color::Ones());
        EXPECT_TRUE(anyOf(original.get()->lobes(), LobeFlags::Delta));
    }
    EXPECT_NEAR(copy.get()->f(up, up, TransportMode::Radiance).z(), 0.3 / pi, 1e-15);
    const BsdfBuffer empty{};
    copy = empty;
    EXPECT_EQ(copy.get(), nullptr);
}

}  // namespace
}  // namespace caustic
