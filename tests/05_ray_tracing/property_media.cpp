#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "scene/scene.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "support/coloured_fog.h"
#include "support/isotropic_phase.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real infinity = std::numeric_limits<Real>::infinity();

// Mean of colours and how sure it is, channel by channel.
class ColorMean {
public:
    void add(const Color& value) {
        ++count_;
        sum_ += value;
        squares_ += value * value;
    }
    // Within 5.5 standard errors: a false alarm once in 10⁷.
    void expect(const Color& expected, const char* what) const {
        const Color mean = sum_ / count_;
        for (int channel = 0; channel < 3; ++channel) {
            const Real variance = std::max(Real(0), squares_[channel] / count_ - mean[channel] * mean[channel]);
            EXPECT_NEAR(mean[channel], expected[channel], 5.5 * std::sqrt(variance / count_) + 1e-12)
                << what << ", channel " << channel;
        }
    }

private:
    Real count_ = 0;
    Color sum_ = Color::Zero();
    Color squares_ = Color::Zero();
};

// Scattered samples bring ∫ σ_s e^(−σ_t x) dx = σ_s/σ_t (1 − e^(−σ_t d)) of each channel, those that pass e^(−σ_t d):
// coloured media, a clear channel, one that only absorbs, directions of any length, ways of any length.
TEST(Medium, DistancesAreUnbiasedInEachChannel) {
    const Color sigmaA[] = {{0.1, 0.9, 0}, {0, 0, 0}, {3, 0, 0.02}, {0.2, 2, 0}};
    const Color sigmaS[] = {{2, 0.3, 0}, {0.7, 0.7, 0.7}, {0.5, 8, 0.1}, {0, 1, 3}};
    for (std::size_t k = 0; k < std::size(sigmaA); ++k) {
        const test::ColouredFog fog(sigmaA[k], sigmaS[k]);
        const Color sigmaT = sigmaA[k] + sigmaS[k];
        for (const Real end : {0.05, 1.3, infinity}) {
            const Ray ray = {Vec3(-3, 0.2, 7), Vec3(0.6, -1.7, 0.4)};
            const Real length = ray.direction.norm();
            Color passes;
            Color scatters;
            for (int channel = 0; channel < 3; ++channel) {
                const Real sigma = sigmaT[channel];
                passes[channel] = sigma == 0 ? 1 : std::exp(-sigma * end);
                scatters[channel] = sigma == 0 ? 0 : sigmaS[k][channel] / sigma * (1 - passes[channel]);
            }
            EXPECT_LE((fog.transmittance(ray, end / length) - passes).abs().maxCoeff(), 1e-12);
            ColorMean scattered;
            ColorMean passed;
            Random random(5, {k, static_cast<std::uint64_t>(end > 1 ? 1 : 0)});
            for (int i = 0; i < 200'000; ++i) {
                const Real u = random.uniform();
                const DistanceSample sample = fog.sampleDistance(ray, end / length, u, random.uniform());
                scattered.add(sample.scattered ? sample.weight : Color(Color::Zero()));
                passed.add(sample.scattered ? Color(Color::Zero()) : sample.weight);
                if (!sample.scattered) continue;
                // The weight is what it says: σ_s T over the density.
                const Color T = fog.transmittance(ray, sample.t);
                EXPECT_LE((sample.weight * sample.pdf - sigmaS[k] * T).abs().maxCoeff(), 1e-12);
                EXPECT_LT(sample.t * length, end);
            }
            scattered.expect(scatters, "scattered");
            passed.expect(passes, "passed");
        }
    }
}

// A medium that only absorbs passes always, and takes no numbers.
TEST(Medium, AbsorptionAloneNeverScatters) {
    const AbsorbingMedium glass(Color(0.4, 0, 2));
    const Ray ray = {Vec3::Zero(), Vec3(0, 3, 0)};
    for (const Real u : {0.0, 0.5, 1 - 1e-12}) {
        const DistanceSample sample = glass.sampleDistance(ray, 0.5, u, u);
        EXPECT_FALSE(sample.scattered);
        EXPECT_EQ(sample.pdf, 1);
        EXPECT_TRUE((sample.weight == glass.transmittance(ray, 0.5)).all());
    }
    EXPECT_EQ(glass.phase(), nullptr);
}

// ∫ p dω = 1, the samples' density is p, and p/p is 1.
TEST(PhaseFunction, IsotropicIsNormalised) {
    const test::IsotropicPhase phase;
    Vec3 sum = Vec3::Zero();
    constexpr int n = 100'000;
    for (std::uint64_t i = 0; i < n; ++i) {
        Random random(8, {i});
        const Real u = random.uniform();
        const PhaseSample sample = phase.sample(Vec3::UnitX(), {u, random.uniform()});
        EXPECT_NEAR(sample.wi.norm(), 1, 1e-12);
        EXPECT_NEAR(sample.p, 1 / (4 * pi), 1e-15);
        EXPECT_EQ(sample.p, sample.pdfW);
        EXPECT_EQ(sample.pdfW, phase.pdfW(Vec3::UnitX(), sample.wi));
        sum += sample.wi;
    }
    EXPECT_LE(sum.norm() / n, 5.5 / std::sqrt(n));
}

SceneObject filled(const Vec3& from, const Vec3& to, std::shared_ptr<const Medium> medium) {
    return {.shape = std::make_shared<Box>(from, to), .interior = Interior{1, std::move(medium), 0}};
}

// Three fogs in a row, with index-matched boundaries and a little empty space between, before a wall. A path that gets
// to the wall carries the product of all transmittances; one that is scattered in the k-th carries those of the fogs
// before it times its own single scattering. The same number for all three would have made the second pass whenever the
// first one does.
TEST(Follow, MediaInARowAreIndependent) {
    const Color sigmaA[] = {{0.3, 0, 0.1}, {0, 0, 0}, {0.2, 0.2, 1}};
    const Color sigmaS[] = {{0.2, 0.8, 0.4}, {1.5, 0.2, 0.7}, {0.5, 0.5, 0}};
    const Real from[] = {0, 0.55, 1.2};
    const Real to[] = {0.5, 1.1, 1.9};
    SceneDescription description;
    for (int k = 0; k < 3; ++k)
        description.objects.push_back(
            filled({from[k], -1, -1}, {to[k], 1, 1}, std::make_shared<test::ColouredFog>(sigmaA[k], sigmaS[k])));
    description.objects.push_back({.shape = std::make_shared<Plane>(Vec3(2.5, 0, 0), -Vec3::UnitX()),
                                   .material = std::make_shared<DiffuseMaterial>(Color::Ones())});
    const Scene scene(description);
    EXPECT_TRUE(scene.needs().scattering);
    const IndependentSampler sampler(3);
    for (const int vertex : {0, 3}) {
        ColorMean wall;
        ColorMean scattered[3];
        RayCounts counts;
        for (int i = 0; i < 200'000; ++i) {
            MediumStack media;
            Color weight;
            const auto at = scene.follow({Vec3(-1, 0.3, 0.1), Vec3::UnitX()}, media, weight,
                                         sampler.start(0, {3, 4}, i), vertex, counts);
            ASSERT_TRUE(at);
            wall.add(at->isSurface() ? weight : Color(Color::Zero()));
            for (int k = 0; k < 3; ++k) {
                const bool here = !at->isSurface() && at->point().x() > from[k] && at->point().x() < to[k];
                scattered[k].add(here ? weight : Color(Color::Zero()));
            }
        }
        Color before = Color::Ones();
        for (int k = 0; k < 3; ++k) {
            const Color sigmaT = sigmaA[k] + sigmaS[k];
            const Color passes = (-sigmaT * (to[k] - from[k])).exp();
            scattered[k].expect(before * sigmaS[k] / sigmaT * (1 - passes), "scattered");
            before *= passes;
        }
        wall.expect(before, "wall");
        EXPECT_EQ(counts.transmittances, 0);
        EXPECT_GT(counts.distanceSamples, 200'000);
    }
}

// Where nothing scatters, a path's next vertex is the surface that follow finds without any numbers.
TEST(Follow, TakesNoNumbersWhereNothingScatters) {
    class NoNumbers final : public Sampler {
    public:
        Real number(const PathName&, Dimension) const override { throw std::logic_error("asked for a number"); }
        Vec2 pair(const PathName&, Dimension) const override { throw std::logic_error("asked for a pair"); }
    };
    SceneDescription description;
    description.objects = {filled({0, -1, -1}, {1, 1, 1}, std::make_shared<AbsorbingMedium>(Color(0.4, 0, 2))),
                           {.shape = std::make_shared<Plane>(Vec3(2, 0, 0), -Vec3::UnitX()),
                            .material = std::make_shared<DiffuseMaterial>(Color::Ones())}};
    const Scene scene(description);
    EXPECT_FALSE(scene.needs().scattering);
    EXPECT_TRUE(scene.needs().medium);
    const NoNumbers none;
    const Ray ray = {Vec3(-1, 0.3, 0.1), Vec3(0.8, 0.1, 0).normalized()};
    RayCounts counts;
    MediumStack one;
    MediumStack two;
    Color weight;
    Color transmittance;
    const auto vertex = scene.follow(ray, one, weight, none.start(0, {0, 0}, 0), 2, counts);
    const auto surface = scene.follow(ray, two, transmittance, counts);
    ASSERT_TRUE(vertex && surface);
    EXPECT_TRUE(vertex->isSurface() && vertex->point() == surface->point());
    EXPECT_TRUE((weight == transmittance).all());
    EXPECT_EQ(counts.distanceSamples, 0);
    EXPECT_EQ(counts.transmittances, 2);
}

// A point of a medium, as connections see it: p for f, no cosine, rays from the very point, the same media wherever
// they go.
TEST(Interaction, IsAPointOfAMedium) {
    const test::ColouredFog fog(Color(0.1, 0.2, 0.3), Color(1, 2, 3));
    const Interior interior = {1, nullptr, 0};
    MediumStack media;
    media.enter(7, interior);
    const Vec3 point(1e3, -2, 5e-3);
    const Interaction at(point, Vec3(0.6, 0, 0.8), *fog.phase(), media);
    EXPECT_FALSE(at.isSurface());
    EXPECT_TRUE(at.scatters() && at.connectible());
    EXPECT_EQ(at.bsdf(), nullptr);
    EXPECT_TRUE((at.Le() == 0).all());
    for (std::uint64_t i = 0; i < 100; ++i) {
        Random random(4, {i});
        const Real u = random.uniform();
        const auto sample = at.sample({u, random.uniform()}, 0.5, TransportMode::Radiance);
        ASSERT_TRUE(sample);
        EXPECT_FALSE(sample->delta() || sample->transmits());
        EXPECT_EQ(sample->eta, 1);
        EXPECT_TRUE((at.f(sample->wi, TransportMode::Importance) == sample->f).all());
        EXPECT_NEAR(at.f(sample->wi, TransportMode::Radiance).x(), 1 / (4 * pi), 1e-15);
        EXPECT_EQ(at.pdfW(sample->wi), sample->pdfW);
        EXPECT_EQ(at.reversePdfW(sample->wi), sample->pdfW);
        EXPECT_EQ(at.cosine(sample->wi), 1);
        EXPECT_EQ(at.geometricCosine(sample->wi), 1);
        EXPECT_EQ(at.spawn(sample->wi).origin, point);
        EXPECT_LE((at.spawnTo(Vec3(1, 2, 3)).at(1) - Vec3(1, 2, 3)).norm(), 1e-12);
        EXPECT_EQ(at.media(sample->wi).object(), 7);
    }
    // To a surface the ray ends before it, from this very point.
    Hit hit;
    hit.point = Vec3(1e3, 4, 0);
    hit.ng = -Vec3::UnitY();
    hit.magnitude = 1e3;
    const Interaction wall(hit, -Vec3::UnitY(), nullptr, {});
    EXPECT_EQ(at.spawnTo(wall).origin, point);
    EXPECT_LT(at.spawnTo(wall).at(1).y(), 4);
    EXPECT_LE((wall.spawnTo(at).at(1) - point).norm(), 1e-12);
}

// The light's point and normal come with the sample: a lamp's are on its surface, a point's have no normal.
TEST(DirectSample, SaysWhereTheLightIs) {
    const PointLight light(Vec3(1, 5, -2), Color(3, 2, 1));
    SurfacePoint from;
    from.point = Vec3(0.3, 0, 0);
    const auto sample = light.sampleDirect(from, {0.2, 0.7});
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->on.point, Vec3(1, 5, -2));
    EXPECT_EQ(sample->on.ng, Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace caustic
