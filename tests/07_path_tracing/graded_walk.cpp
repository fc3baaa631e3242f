#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "integrator/roulette.h"
#include "integrator/scatter.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "sampling/independent_sampler.h"
#include "scene/scene.h"
#include "shape/plane.h"

namespace caustic {
namespace {

const IndependentSampler sampler(1);

// A floor at y = 0, and where a ray meets it that comes down with this cosine.
Interaction onFloor(const Scene& scene, Real cosine) {
    const Vec3 down(std::sqrt(1 - cosine * cosine), -cosine, 0);
    MediumStack media;
    Color passed;
    RayCounts counts;
    return *scene.follow({Vec3(0, 1, 0), down}, media, passed, counts);
}

SceneObject floor(const std::shared_ptr<const Material>& material) {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = material};
}

// f |cos| / p of a diffuse surface is its reflectance, wherever the sample goes: the density is cos θ / π, f is ρ / π.
TEST(Scatter, DiffuseStepsCarryTheReflectance) {
    const Color reflectance(0.2, 0.6, 0.9);
    const Scene scene({.objects = {floor(std::make_shared<DiffuseMaterial>(reflectance))}});
    const Interaction at = onFloor(scene, 0.3);
    for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
        for (int i = 0; i < 200; ++i) {
            const auto step = scatter(at, mode, sampler.start(0, {0, 0}, i), i % 3);
            ASSERT_TRUE(step);
            EXPECT_GT(step->sample.wi.y(), 0);
            EXPECT_LE((step->weight - reflectance).abs().maxCoeff(), 1e-12)
                << "Is f multiplied by the cosine and divided by the density?";
        }
    }
}

// A delta lobe's f is what the direction's whole light is multiplied by, its density the probability of the lobe. Glass
// that reflects 0.3 and refracts 0.7 of the light picks its lobes so: each step carries all, in radiance divided by η²
// where it is refracted.
TEST(Scatter, DeltaLobesHaveNoCosine) {
    const auto mirror = std::make_shared<MirrorMaterial>(Color(0.2, 0.5, 0.8));
    const Scene mirrors({.objects = {floor(mirror)}});
    const auto reflected = scatter(onFloor(mirrors, 0.3), TransportMode::Radiance, sampler.start(0, {0, 0}, 0), 0);
    ASSERT_TRUE(reflected);
    EXPECT_LE((reflected->weight - Color(0.2, 0.5, 0.8)).abs().maxCoeff(), 1e-12) << "Is there a cosine in it?";

    SceneObject glass = floor(std::make_shared<RefractionMaterial>(Color::Constant(0.3), Color::Constant(0.7)));
    glass.interior = Interior{1.5, nullptr, 0};
    const Scene scene({.objects = {glass}});
    const Interaction at = onFloor(scene, 0.4);
    constexpr int n = 20'000;
    int refractions = 0;
    for (int i = 0; i < n; ++i) {
        const TransportMode mode = i % 2 == 0 ? TransportMode::Radiance : TransportMode::Importance;
        const auto step = scatter(at, mode, sampler.start(0, {0, 0}, i), 1);
        ASSERT_TRUE(step);
        const bool scaled = step->sample.transmits() && mode == TransportMode::Radiance;
        EXPECT_NEAR(step->weight.x(), scaled ? 1 / 2.25 : 1, 1e-12) << "Is the lobe's probability divided by?";
        refractions += step->sample.transmits() ? 1 : 0;
    }
    EXPECT_NEAR(refractions, 0.7 * n, 5 * std::sqrt(0.21 * n)) << "Does the lobe have a number of its own?";
}

// The mean of what survivors are multiplied by, over all u, is 1: what roulette takes from some it gives to others.
TEST(Roulette, KeepsTheMean) {
    constexpr int n = 100'000;
    for (const Real share : {0.013, 0.25, 0.5, 0.83}) {
        Real sum = 0;
        for (int i = 0; i < n; ++i) {
            const auto survivor = roulette(Color(0.1 * share, share, 0), (i + 0.5) / n);
            if (survivor) sum += *survivor;
        }
        EXPECT_NEAR(sum / n, 1, 2 / (share * n)) << "Does a survivor count for those that ended?";
    }
    EXPECT_FALSE(roulette(Color::Zero(), 0)) << "Can a path go on that carries nothing?";
}

// The largest channel decides, so that no colour is ever multiplied up beyond what it set out with; and what carries as
// much as at its start, or more, has nothing to lose.
TEST(Roulette, SparesWhatCarriesMuch) {
    for (const Real u : {0.0, 0.3, 0.999}) {
        for (const Color& share : {Color(1, 0, 0), Color(0, 0.5, 1.7), Color(40, 1, 1)}) {
            const auto survivor = roulette(share, u);
            ASSERT_TRUE(survivor) << "Does it ask the largest channel?";
            EXPECT_EQ(*survivor, 1) << "Is a probability above 1 taken for one?";
        }
    }
}

}  // namespace
}  // namespace caustic
