#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "integrator/direct_light.h"
#include "integrator/path_tracer.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const IndependentSampler sampler(1);
const BoxFilter box;

SceneObject floor() {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()),
            .material = std::make_shared<DiffuseMaterial>(Color::Constant(0.5))};
}

std::shared_ptr<Light> pointLight(const Vec3& position, Real intensity) {
    return std::make_shared<PointLight>(position, Color::Constant(intensity));
}

// A lamp of 2 m × 1 m at a height of 1.5 m that shines downwards.
SceneObject lamp(Real radiance) {
    SceneObject one;
    one.shape = std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));
    one.emission = std::make_shared<ConstantTexture>(Color::Constant(radiance));
    return one;
}

// Where the floor is met at x = z = 0.
Interaction onFloor(const Scene& scene) {
    MediumStack media;
    Color passed;
    RayCounts counts;
    return *scene.follow({Vec3(0, 0.4, 0), -Vec3::UnitY()}, media, passed, counts);
}

// What sampleDirectLight brings on average must be the expected value, within 5.5 standard errors.
void expectDirect(const Scene& scene, Real expected, const std::string& question) {
    const LightChoice lights(scene.lights());
    const Interaction at = onFloor(scene);
    constexpr int n = 200'000;
    Real sum = 0;
    Real squares = 0;
    RayCounts counts;
    for (int i = 0; i < n; ++i) {
        const auto direct = sampleDirectLight(scene, lights, at, i % 3, sampler.start(0, {0, 0}, i), counts);
        const Real one = direct ? direct->value.x() : 0;
        sum += one;
        squares += one * one;
    }
    const Real mean = sum / n;
    const Real error = std::sqrt(std::max(Real(0), squares / n - mean * mean) / n);
    EXPECT_NEAR(mean, expected, 5.5 * error + 1e-9 * expected) << question;
}

// ρ/π I cos θ / d² of each light, whichever is chosen how often. And what an answer brings times its density is what
// the chosen light brings by itself.
TEST(DirectLight, PointsAreChosenByPowerAndDividedByIt) {
    const Scene scene({.objects = {floor()}, .lights = {pointLight({0, 2, 0}, 4), pointLight({3, 4, 0}, 100)}});
    const Real single[2] = {0.5 / pi * 4.0 / 4, 0.5 / pi * 100.0 * 0.8 / 25};
    expectDirect(scene, single[0] + single[1], "Is it divided by the probability of the light?");
    const LightChoice lights(scene.lights());
    const Interaction at = onFloor(scene);
    RayCounts counts;
    for (int i = 0; i < 100; ++i) {
        const auto direct = sampleDirectLight(scene, lights, at, 0, sampler.start(0, {0, 0}, i), counts);
        ASSERT_TRUE(direct);
        const std::size_t chosen = direct->light.light == scene.lights()[0].get() ? 0 : 1;
        EXPECT_NEAR(direct->pdfW * direct->value.x(), single[chosen], 1e-9) << "Is the density that of both choices?";
    }
}

// ρ L F with the form factor F of a rectangle with a corner straight above, in closed form; four of them make the lamp.
TEST(DirectLight, ALampBringsItsFormFactor) {
    const Scene scene({.objects = {floor(), lamp(7)}});
    const Real x = 1 / 1.5;
    const Real y = 0.5 / 1.5;
    const Real corner = x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                        y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y));
    expectDirect(scene, 0.5 * 7 * 4 * corner / (2 * pi), "f, the cosine, the radiance, the density of the direction?");
}

// A wall in the way leaves nothing of the light; a tinted pane without a surface e^(−σ d).
TEST(DirectLight, AsksWhatIsInTheWay) {
    SceneObject pane;
    pane.shape = std::make_shared<Box>(Vec3(-9, 1, -9), Vec3(9, 1.5, 9));
    pane.interior = Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(1.2)), 0};
    const Scene tinted({.objects = {floor(), pane}, .lights = {pointLight({0, 2, 0}, 4)}});
    expectDirect(tinted, 0.5 / pi * std::exp(-0.6), "What does the pane let pass?");

    SceneObject wall = floor();
    wall.shape = pane.shape;
    const Scene dark({.objects = {floor(), wall}, .lights = {pointLight({0, 2, 0}, 4)}});
    expectDirect(dark, 0, "Is there a shadow?");
}

const Scene& anyScene() {
    static const Scene scene({.objects = {floor(), lamp(7)}});
    return scene;
}

// Where both ways lead to a light, each counts by the power heuristic, and the two weights sum to 1 (Veach, eq. 9.13).
TEST(LightWeight, IsThePowerHeuristicOfBothWays) {
    const PathTracer tracer(anyScene(), sampler, box, {.direct = Direct::Mis});
    for (const Real asked : {0.02, 1.0, 7.0}) {
        for (const Real chance : {0.01, 0.3, 20.0}) {
            const Real all = asked * asked + chance * chance;
            EXPECT_NEAR(tracer.weight(PathTracer::Sampled::Light, asked, chance), asked * asked / all, 1e-12)
                << "Whose density stands above?";
            EXPECT_NEAR(tracer.weight(PathTracer::Sampled::Direction, asked, chance), chance * chance / all, 1e-12)
                << "Whose density stands above?";
        }
    }
}

// Where only one way leads to a light it counts in full: nobody asks at the eye and behind a mirror, and no path hits a
// point. Where always somebody asks, what is met by chance must not count again.
TEST(LightWeight, CountsEverythingOnce) {
    using Sampled = PathTracer::Sampled;
    const PathTracer chance(anyScene(), sampler, box, {.direct = Direct::ByChance});
    const PathTracer asking(anyScene(), sampler, box, {.direct = Direct::DirectLight});
    const PathTracer both(anyScene(), sampler, box, {.direct = Direct::Mis});
    for (const PathTracer* const one : {&chance, &asking, &both})
        EXPECT_EQ(one->weight(Sampled::Direction, 0, 0.7), 1) << "Does anybody ask behind a mirror?";
    for (const PathTracer* const one : {&asking, &both})
        EXPECT_EQ(one->weight(Sampled::Light, 0.7, 0), 1) << "Does any path hit a light at a point?";
    EXPECT_EQ(chance.weight(Sampled::Direction, 2, 0.7), 1) << "With this setting nobody asks.";
    EXPECT_EQ(asking.weight(Sampled::Light, 2, 0.7), 1) << "With this setting somebody always asks.";
    EXPECT_EQ(asking.weight(Sampled::Direction, 2, 0.7), 0) << "Is this light counted twice?";
}

}  // namespace
}  // namespace caustic
