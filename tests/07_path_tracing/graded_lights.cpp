#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
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
    return {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()),
            std::make_shared<DiffuseMaterial>(Color::Constant(0.5)),
            {},
            nullptr};
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

// What PathTracer::direct brings on average must be the expected value, within 5.5 standard errors.
void expectDirect(const Scene& scene, Direct direct, Real expected, const std::string& question) {
    const PathTracer tracer(scene, sampler, box, {.direct = direct});
    const Interaction at = onFloor(scene);
    constexpr int n = 200'000;
    Real sum = 0;
    Real squares = 0;
    RayCounts counts;
    for (int i = 0; i < n; ++i) {
        const Real one = tracer.direct(at, i % 3, sampler.start(0, {0, 0}, i), counts).x();
        sum += one;
        squares += one * one;
    }
    const Real mean = sum / n;
    const Real error = std::sqrt(std::max(Real(0), squares / n - mean * mean) / n);
    EXPECT_NEAR(mean, expected, 5.5 * error + 1e-9 * expected) << question;
}

// ρ/π I cos θ / d² of each light, whichever is chosen how often; and that no walk hits a point, whatever its settings.
TEST(DirectLight, PointsAreChosenByPowerAndDividedByIt) {
    const Scene scene({{floor()}, {pointLight({0, 2, 0}, 4), pointLight({3, 4, 0}, 100)}, Color::Zero(), nullptr});
    const Real expected = 0.5 / pi * (4.0 / 4 + 100.0 * 0.8 / 25);
    expectDirect(scene, Direct::DirectLight, expected, "Is it divided by the probability of the light?");
    expectDirect(scene, Direct::Mis, expected, "Can a walk hit a light at a point by chance?");
}

// ∫ f L cos θ cos θ' / d² w dA over the lamp, w = p² / (p² + q²): p the density of choosing the lamp and that
// direction, q the floor's, cos θ / π; both over solid angle. By the midpoint rule.
TEST(DirectLight, WeighsItselfAgainstChance) {
    const Scene scene({{floor(), lamp(7)}, {pointLight({0, 900, 0}, 3)}, Color::Zero(), nullptr});
    const Real lampPower = pi * 2 * 7;
    const Real choice = lampPower / (lampPower + 4 * pi * 3);
    constexpr int side = 500;
    Real expected = 0;  // the lamp hides the point light from the floor
    for (int i = 0; i < side * side; ++i) {
        const Vec3 on(-1 + 2 * (i % side + 0.5) / side, 1.5, -0.5 + (i / side + 0.5) / side);
        const Real cosine = 1.5 / on.norm();
        const Real p = choice * on.squaredNorm() / (2 * cosine);
        const Real q = cosine / pi;
        expected += 2.0 / (side * side) * 0.5 / pi * 7 * cosine * cosine / on.squaredNorm() * p * p / (p * p + q * q);
    }
    expectDirect(scene, Direct::Mis, expected, "Which density does the weight take for asking, and in which measure?");
}

// A wall in the way leaves nothing of the light; a tinted pane without a surface e^(−σ d).
TEST(DirectLight, AsksWhatIsInTheWay) {
    SceneObject pane;
    pane.shape = std::make_shared<Box>(Vec3(-9, 1, -9), Vec3(9, 1.5, 9));
    pane.interior = Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(1.2)), 0};
    const Scene tinted({{floor(), pane}, {pointLight({0, 2, 0}, 4)}, Color::Zero(), nullptr});
    expectDirect(tinted, Direct::DirectLight, 0.5 / pi * std::exp(-0.6), "What does the pane let pass?");

    SceneObject wall = floor();
    wall.shape = pane.shape;
    const Scene dark({{floor(), wall}, {pointLight({0, 2, 0}, 4)}, Color::Zero(), nullptr});
    expectDirect(dark, Direct::DirectLight, 0, "Is there a shadow?");
}

// The power heuristic with the density of asking for this very light: its probability times that of the direction.
TEST(ChanceWeight, IsWhatAskingLeaves) {
    const Scene scene({{floor(), lamp(7)}, {pointLight({0, 9, 0}, 3)}, Color::Zero(), nullptr});
    const PathTracer tracer(scene, sampler, box, {.direct = Direct::Mis});
    const Real choice = pi * 2 * 7 / (pi * 2 * 7 + 4 * pi * 3);
    for (const Real own : {0.01, 0.3, 20.0}) {
        for (const Real asked : {0.02, 1.0, 7.0}) {
            const Real p = choice * asked;
            EXPECT_NEAR(tracer.chanceWeight({false, Vec3::Zero(), own}, *scene.lights()[0], asked),
                        own * own / (own * own + p * p), 1e-12)
                << "Is the light's probability part of the density with which it is asked for?";
        }
    }
}

// What nothing asks for counts as it is found: seen from the eye or over a delta lobe, or when no light is asked for at
// all. What is always asked for must not count again.
TEST(ChanceWeight, CountsWhatNobodyAskedFor) {
    const Scene scene({{floor(), lamp(7)}, {}, Color::Zero(), nullptr});
    const Light& light = *scene.lights()[0];
    for (const Direct direct : {Direct::ByChance, Direct::DirectLight, Direct::Mis}) {
        const PathTracer tracer(scene, sampler, box, {.direct = direct});
        EXPECT_EQ(tracer.chanceWeight({true, Vec3::Zero(), 0.7}, light, 2), 1)
            << "Does the surface before it ask for lights, if it is smooth?";
    }
    const PathTracer chance(scene, sampler, box, {.direct = Direct::ByChance});
    EXPECT_EQ(chance.chanceWeight({false, Vec3::Zero(), 0.7}, light, 2), 1) << "Nobody asks for lights here.";
    const PathTracer asking(scene, sampler, box, {.direct = Direct::DirectLight});
    EXPECT_EQ(asking.chanceWeight({false, Vec3::Zero(), 0.7}, light, 2), 0) << "Is this light counted twice?";
}

}  // namespace
}  // namespace caustic
