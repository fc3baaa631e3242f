#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>

#include "integrator/roulette.h"
#include "integrator/scatter.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/refraction_material.h"
#include "support/recording_sampler.h"
#include "texture/constant_texture.h"
#include "vertex_scenes.h"

namespace caustic {
namespace {

Scene of(const std::vector<SceneObject>& objects) { return Scene({objects, {}, Color::Zero(), nullptr}); }

// A plane off the origin, at y = 2, and where a ray meets it that comes down with this cosine.
Interaction onFloor(const Scene& scene, Real cosine) {
    const Vec3 down(std::sqrt(1 - cosine * cosine), -cosine, 0);
    const Vec3 point(3, 2, -5);
    return test::meet(scene, point - down, point);
}

SceneObject floor(const std::shared_ptr<const Material>& material, const Vec3& ns = Vec3::UnitY()) {
    return {test::leaningPlane({3, 2, -5}, Vec3::UnitY(), ns, 9), material, {}, nullptr};
}

const std::shared_ptr<const Material> shiny =
    std::make_shared<PhongMaterial>(std::make_shared<ConstantTexture>(Color(0.2, 0.4, 0.1)), Color(0.3, 0.1, 0.6), 12);

std::optional<Scattering> step(const Interaction& at, TransportMode mode, int index, int vertex = 0) {
    return scatter(at, mode, test::independent.start(0, {0, 0}, index), vertex);
}

// f |cos| / p: of a diffuse surface that is its reflectance, wherever the sample goes. On smooth normals, with a
// highlight: f and the cosine are those of the sample's direction and of what the path carries, the density is that of
// the direction. In a medium all goes on.
TEST(Scatter, WeighsTheDirectionThatItTakes) {
    const Scene plain = of({floor(test::diffuse(test::rho))});
    const Interaction onPlain = onFloor(plain, 0.3);
    for (int i = 0; i < 200; ++i) {
        const TransportMode mode = i % 2 == 0 ? TransportMode::Radiance : TransportMode::Importance;
        const auto next = step(onPlain, mode, i, i % 3);
        ASSERT_TRUE(next);
        EXPECT_GT(next->sample.wi.y(), 0);
        test::expectColor(next->weight, test::rho, "Is f multiplied by the cosine and divided by the density?");
    }
    const Vec3 ns = Vec3(0.3, 1, 0.1).normalized();
    const Scene scene = of({floor(shiny, ns)});
    const Interaction at = onFloor(scene, 0.5);
    for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
        for (int i = 0; i < 500; ++i) {
            const auto next = step(at, mode, i);
            if (!next) continue;
            const Vec3& wi = next->sample.wi;
            const Color f = at.f(wi, mode);
            EXPECT_NEAR(next->sample.pdfW / at.pdfW(wi), 1, 1e-9) << "Is the sample handed on as it was drawn?";
            EXPECT_LE((next->sample.f - f).abs().maxCoeff(), 1e-9 * f.maxCoeff())
                << "Is the sample handed on as it was drawn? What does the path carry?";
            EXPECT_LE((next->weight - f * (std::abs(wi.dot(ns)) / at.pdfW(wi))).abs().maxCoeff(), 1e-9)
                << "Which cosine, and of which direction?";
        }
    }
    const test::ForwardPhase phase;
    const Vec3 wo(0.48, 0.6, 0.64);
    const Interaction inside({1, 2, 3}, wo, phase, {});
    for (int i = 0; i < 100; ++i) {
        const auto next = step(inside, TransportMode::Radiance, i);
        ASSERT_TRUE(next);
        test::expectColor(next->weight, Color::Constant(1 - wo.dot(next->sample.wi) / 2),
                          "Is there a cosine in a medium?");
    }
}

// A pair of numbers for the direction and one for the lobe, those of the vertex: they have nothing to do with each
// other, nor with those of the next vertex.
TEST(Scatter, TakesTheNumbersOfItsVertex) {
    const Scene scene = of({floor(shiny)});
    const Interaction at = onFloor(scene, 0.5);
    const test::RecordingSampler sampler;
    std::set<Real> directions;
    int count = 0;
    for (int vertex = 0; vertex < 5; ++vertex) {
        for (int i = 0; i < 100; ++i) {
            sampler.forget();
            const auto next = scatter(at, TransportMode::Radiance, sampler.start(0, {0, 0}, i), vertex);
            std::set<int> dimensions;
            for (const auto& asked : sampler.asked()) dimensions.insert(asked.dimension);
            const std::set<int> expected = {Dimension::vertex(vertex, VertexUse::Direction).index,
                                            Dimension::vertex(vertex, VertexUse::Lobe).index};
            EXPECT_EQ(dimensions, expected) << "VertexUse says what numbers are for. Whose vertex is it?";
            if (!next) continue;
            ++count;
            directions.insert(next->sample.wi.x());
        }
    }
    EXPECT_EQ(directions.size(), static_cast<std::size_t>(count)) << "Do two steps use the same numbers?";
}

// A delta lobe's f is what the direction's whole light is multiplied by, its density the probability of the lobe. Glass
// that reflects 0.3 and refracts 0.7 of the light picks its lobes so: each step carries all, in radiance divided by η²
// where it is refracted.
TEST(Scatter, DeltaLobesHaveNoCosine) {
    const Color R(0.2, 0.5, 0.8);
    const Scene mirrors = of({floor(std::make_shared<MirrorMaterial>(R))});
    const auto reflected = step(onFloor(mirrors, 0.3), TransportMode::Radiance, 0);
    ASSERT_TRUE(reflected);
    test::expectColor(reflected->weight, R, "Is there a cosine in it?");

    SceneObject glass = floor(std::make_shared<RefractionMaterial>(Color(0.1, 0.3, 0.2), Color(0.7, 0.4, 0.5)));
    glass.interior = Interior{1.5, nullptr, 0};
    const Scene scene = of({glass});
    const Interaction at = onFloor(scene, 0.4);
    constexpr int n = 20'000;
    int refractions = 0;
    for (int i = 0; i < n; ++i) {
        const TransportMode mode = i % 2 == 0 ? TransportMode::Radiance : TransportMode::Importance;
        const auto next = step(at, mode, i, 1);
        ASSERT_TRUE(next);
        Color expected = Color(0.1, 0.3, 0.2) / 0.3;
        if (next->sample.transmits())
            expected = Color(0.7, 0.4, 0.5) / 0.7 / (mode == TransportMode::Radiance ? 2.25 : 1);
        test::expectColor(next->weight, expected, "Is the lobe's probability divided by? In which mode?");
        refractions += next->sample.transmits() ? 1 : 0;
    }
    EXPECT_NEAR(refractions, 0.7 * n, 5.5 * std::sqrt(0.21 * n)) << "Does the lobe have a number of its own?";
}

// The mean of what survivors are multiplied by, over all u, is 1: what roulette takes from some it gives to others. As
// many survive as the largest channel says.
TEST(Roulette, KeepsTheMean) {
    constexpr int n = 100'000;
    for (const Real share : {0.013, 0.25, 0.5, 0.83, 0.99}) {
        for (int channel = 0; channel < 3; ++channel) {
            Color carried(0.1 * share, 0, 0.7 * share);
            carried[channel] = share;
            Real sum = 0;
            int survivors = 0;
            for (int i = 0; i < n; ++i) {
                const auto survivor = roulette(carried, (i + 0.5) / n);
                if (!survivor) continue;
                sum += *survivor;
                ++survivors;
            }
            EXPECT_NEAR(sum / n, 1, 2 / (share * n)) << "Does a survivor count for those that ended?";
            EXPECT_NEAR(survivors, share * n, 2) << "How many paths end?";
        }
    }
    for (const Real u : {0.01, 0.99}) {
        const auto survivor = roulette(Color(0.1, 0.3, 0.2), u);
        EXPECT_NEAR(survivor.value_or(1 / 0.3), 1 / 0.3, 1e-12) << "Does a survivor count for those that ended?";
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
