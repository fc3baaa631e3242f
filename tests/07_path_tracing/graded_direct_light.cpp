#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include "integrator/direct_light.h"
#include "light/point_light.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/form_factor.h"
#include "support/recording_light.h"
#include "support/recording_sampler.h"
#include "texture/constant_texture.h"
#include "vertex_scenes.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

std::shared_ptr<PointLight> pointLight(const Vec3& position, const Color& intensity) {
    return std::make_shared<PointLight>(position, intensity);
}

Scene of(const std::vector<SceneObject>& objects, const std::vector<std::shared_ptr<Light>>& lights) {
    return Scene({objects, lights, Color::Zero(), nullptr});
}

std::optional<DirectLight> sampled(const Scene& scene, const Interaction& at, int index = 0, int vertex = 0) {
    const LightChoice lights(scene.lights());
    RayCounts counts;
    return sampleDirectLight(scene, lights, at, vertex, test::independent.start(0, {0, 0}, index), counts);
}

// Of the only light of a scene, which is at a point: no chance is in it.
Color value(const Scene& scene, const Interaction& at) {
    const auto direct = sampled(scene, at);
    EXPECT_TRUE(direct) << "Is light lost that gets there?";
    return direct ? direct->value : Color::Zero();
}

void expectNothing(const Scene& scene, const Interaction& at, const char* question) {
    EXPECT_FALSE(sampled(scene, at)) << question;
}

// ρ/π I cos θ / d² of each of two lights at points, whichever is chosen how often, on a plane that stands askew and is
// smooth or isn't, at any size. What an answer brings times its density is what the chosen light brings by itself; and
// lights are chosen in proportion to their power.
TEST(DirectLight, PointsAreChosenByPowerAndDividedByIt) {
    const Vec3 ng = Vec3(0.36, -0.48, 0.8);
    const Color intensities[2] = {Color(4, 1, 2), Color(0, 3, 12)};
    const Vec3 ways[2] = {Vec3(1, -0.3, 2), Vec3(-0.4, -2, 0.5)};
    for (const Vec3& ns : {ng, Vec3(Vec3(0.2, -0.7, 0.65).normalized())}) {
        for (const Real size : test::sizes) {
            const Vec3 point = size * Vec3(-2, 5, 1);
            const SceneObject plane = {
                test::leaningPlane(point, ng, ns, 9 * size), test::diffuse(test::rho), {}, nullptr};
            const Scene scene = of({plane}, {pointLight(point + size * ways[0], size * size * intensities[0]),
                                             pointLight(point + size * ways[1], size * size * intensities[1])});
            const Interaction at = test::meet(scene, point + size * (ng + Vec3(0.3, 0.2, 0)), point);
            int second = 0;
            for (int i = 0; i < 2000; ++i) {
                const auto direct = sampled(scene, at, i, i % 3);
                ASSERT_TRUE(direct);
                const int chosen = direct->light.light == scene.lights()[0].get() ? 0 : 1;
                second += chosen;
                const Vec3& way = ways[chosen];
                const Color single = test::rho / pi * intensities[chosen] * ns.dot(way) / std::pow(way.norm(), 3);
                EXPECT_NEAR(direct->pdfW, chosen == 1 ? 0.75 : 0.25, 1e-12)
                    << "The density is that of both choices: of the light, by its power, and of the direction.";
                test::expectColor(direct->value, single / direct->pdfW,
                                  "f, the cosine, the radiance, over the density of both choices?");
            }
            EXPECT_NEAR(second, 1500, 5.5 * std::sqrt(375)) << "Which light do the numbers choose?";
        }
    }
}

// ρ L F of a rectangle, with its form factor F in closed form.
TEST(DirectLight, ALampBringsItsFormFactor) {
    const Color radiance(7, 2, 4);
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));
    lamp.emission = std::make_shared<ConstantTexture>(radiance);
    const Scene scene = of({test::floorAt(0, test::rho), lamp}, {});
    const Interaction at = test::meet(scene, {0.5, 0.4, 0.1}, {0.4, 0, 0.1});
    const Color expected = test::rho * radiance * test::formFactor(-1.4, 0.6, -0.6, 0.4, 1.5);
    constexpr int n = 100'000;
    Color sum = Color::Zero();
    Color squares = Color::Zero();
    for (int i = 0; i < n; ++i) {
        const auto direct = sampled(scene, at, i, i % 3);
        ASSERT_TRUE(direct);
        sum += direct->value;
        squares += direct->value.square();
    }
    const Color mean = sum / n;
    const Color error = ((squares / n - mean.square()) / n).sqrt();
    EXPECT_LE(((mean - expected) / error).abs().maxCoeff(), 5.5)
        << "f, the cosine, the radiance, the density of the direction?";
}

// What is handed on: the light, its probability, the sample of it; weights and connections are made of these.
TEST(DirectLight, TellsWhatWasSampled) {
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));
    lamp.emission = std::make_shared<ConstantTexture>(Color(3, 2, 1));
    const Scene scene = of({test::floorAt(0, test::rho), lamp}, {pointLight({0.5, 2, 3}, Color(9, 1, 5))});
    const LightChoice lights(scene.lights());
    const Interaction at = test::meet(scene, {0.5, 0.4, 0.1}, {0.4, 0, 0.1});
    bool chosen[2] = {false, false};
    for (int i = 0; i < 100; ++i) {
        const auto direct = sampled(scene, at, i);
        ASSERT_TRUE(direct && direct->light.light) << "Which light is it?";
        const Light& light = *direct->light.light;
        const bool point = light.deltaPlace();
        chosen[point ? 1 : 0] = true;
        EXPECT_EQ(direct->light.probability, lights.probability(light)) << "How likely was this light?";
        const Vec3 way = direct->sample.on.point - at.point();
        EXPECT_NEAR(direct->sample.on.point.y(), point ? 2 : 1.5, 1e-12) << "Is the sample handed on?";
        EXPECT_LE((direct->sample.wi - way.normalized()).norm(), 1e-12) << "Is the sample handed on?";
        const Real pdfW = point ? 1 : light.pdfW(at.point(), direct->sample.on);
        EXPECT_NEAR(direct->sample.pdfW / pdfW, 1, 1e-9) << "Does the sample keep the density of its direction alone?";
        EXPECT_NEAR(direct->pdfW / (pdfW * direct->light.probability), 1, 1e-9) << "Are both densities in it?";
        const Color radiance = point ? Color(Color(9, 1, 5) / way.squaredNorm()) : Color(3, 2, 1);
        test::expectColor(direct->sample.radiance, radiance, "Is the sample handed on as the light gave it?");
    }
    EXPECT_TRUE(chosen[0] && chosen[1]);
}

// Every vertex of every path has numbers of its own, one for the light and a pair for its point, of the dimensions that
// are meant for that.
TEST(DirectLight, TakesTheNumbersOfItsVertex) {
    const auto one = std::make_shared<test::RecordingLight>(pointLight({0, 2, 0}, Color::Ones()));
    const auto other = std::make_shared<test::RecordingLight>(pointLight({1, 2, 0}, Color::Ones()));
    const Scene scene = of({test::floorAt(0, test::rho)}, {one, other});
    const LightChoice lights(scene.lights());
    const Interaction at = test::meet(scene, {0.5, 0.4, 0.1}, {0.4, 0, 0.1});
    const test::RecordingSampler sampler;
    RayCounts counts;
    std::set<Real> pairs[2];
    int together = 0;
    for (int vertex = 0; vertex < 5; ++vertex) {
        for (int i = 0; i < 100; ++i) {
            sampler.forget();
            sampleDirectLight(scene, lights, at, vertex, sampler.start(0, {0, 0}, i), counts);
            std::set<int> dimensions;
            for (const auto& asked : sampler.asked()) dimensions.insert(asked.dimension);
            const std::set<int> expected = {Dimension::vertex(vertex, VertexUse::LightChoice).index,
                                            Dimension::vertex(vertex, VertexUse::LightPoint).index};
            EXPECT_EQ(dimensions, expected) << "VertexUse says what numbers are for. Whose vertex is it?";
            const bool first = !one->asked().empty();
            const Vec2 u = (first ? one : other)->asked().back();
            pairs[0].insert(u.x());
            pairs[1].insert(u.y());
            together += (u.x() < 0.5) == first ? 1 : 0;
            one->forget();
            other->forget();
        }
    }
    EXPECT_EQ(pairs[0].size(), 500U) << "Is the point of the light picked anew each time?";
    EXPECT_EQ(pairs[1].size(), 500U) << "Is the point of the light picked anew each time?";
    EXPECT_NEAR(together, 250, 5.5 * std::sqrt(125)) << "Does the choice of the light say which point of it is picked?";
}

// A wall in the way, a light behind the surface, a black surface: nothing. One colour may end where others go on.
TEST(DirectLight, AsksWhatIsInTheWay) {
    const auto place = [](const Scene& scene) { return test::meet(scene, {0.1, 0.4, 0}, {0, 0, 0}); };
    const auto lamp = pointLight({0, 2, 0}, Color(4, 1, 2));
    const Scene open = of({test::floorAt(0, test::rho)}, {lamp});
    const Color clear = value(open, place(open));
    const SceneObject wall = {std::make_shared<Rectangle>(Vec3(-9, 1, -9), Vec3(18, 0, 0), Vec3(0, 0, 18)),
                              test::diffuse(test::rho),
                              {},
                              nullptr};
    const Scene dark = of({test::floorAt(0, test::rho), wall}, {lamp});
    expectNothing(dark, place(dark), "Is there a shadow?");
    const Scene black = of({test::floorAt(0, Color::Zero())}, {lamp});
    expectNothing(black, place(black), "What does a black floor scatter?");
    expectNothing(open, test::meet(open, {0, -1, 0}, {0, 0, 0}), "Does light go through the floor?");
    const Scene below = of({test::floorAt(0, test::rho)}, {pointLight({0, 0, 0}, Color::Ones())});
    expectNothing(below, place(below), "Which direction leads to a light where one is?");
    const Scene none = of({test::floorAt(0, test::rho)}, {});
    expectNothing(none, place(none), "And if there is no light?");
    for (const Color& channels : {Color(0.8, 0, 0.3), Color(0, 0.5, 0.3), Color(0.8, 0.5, 0)}) {
        const Scene scene = of({test::floorAt(0, channels)}, {lamp});
        test::expectColor(value(scene, place(scene)), clear * channels / test::rho,
                          "Does light end when one of its colours does?");
    }
    // One of two lights shows its back: whenever it is chosen nothing comes.
    SceneObject back;
    back.shape = std::make_shared<Rectangle>(Vec3(-1, 3, -1), Vec3(0, 0, 1), Vec3(1, 0, 0));
    back.emission = std::make_shared<ConstantTexture>(Color(5, 6, 7));
    const Scene two = of({test::floorAt(0, test::rho), back}, {lamp});
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        const auto direct = sampled(two, place(two), i);
        if (!direct) continue;
        ++found;
        ASSERT_TRUE(direct->light.light->deltaPlace()) << "What if the light gives no sample?";
        test::expectColor(direct->value * direct->pdfW, clear, "What if the other light gives no sample?");
    }
    EXPECT_GT(found, 20);
    EXPECT_LT(found, 180) << "What if the light gives no sample?";
    const Scene ceiling = of({test::floorAt(0, test::rho), test::floorAt(2.001, test::rho)}, {lamp});
    test::expectColor(value(ceiling, place(ceiling)), clear, "What is behind the lamp is not in the way.");
    for (const Real size : test::sizes) {
        const SceneObject ball = {
            std::make_shared<Sphere>(Vec3(size, 0, 0), size), test::diffuse(test::rho), {}, nullptr};
        const Scene scene = of({ball}, {pointLight({size, 9 * size, 0}, Color::Ones())});
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = size * Vec3(1 + 0.9 * std::cos(i), 3, 0.9 * std::sin(2.0 * i));
            EXPECT_GT(value(scene, test::meet(scene, from, {size, 0, 0})).minCoeff(), 0)
                << "Does the ball shade itself?";
        }
    }
}

// Tinted air lets e^(−σ d) pass, of each colour. Paper around it is lit from both sides: what the shadow ray starts in
// depends on the side that it goes to. At a point where a medium scatters, the phase function takes the place of f, and
// there is no cosine.
TEST(DirectLight, IsAbsorbedOnItsWay) {
    const Color thick(5000, 0.1, 0.7);
    const Color intensity(4, 1, 2);
    const auto lamp = pointLight({0, 2, 0}, intensity);
    for (const auto& [low, high] :
         {std::pair(1.0, 1.5), std::pair(-5.0, 1.5), std::pair(-5.0, 9.0), std::pair(1.0, 9.0)}) {
        const Scene scene =
            of({test::floorAt(0, test::rho), test::tintedAir({-9, low, -9}, {9, high, 9}, thick)}, {lamp});
        Color expected = test::rho / pi * intensity / 4 * (-thick * (std::min(2.0, high) - std::max(0.0, low))).exp();
        expected.x() = 0;
        test::expectColor(value(scene, test::meet(scene, {0.01, 0.2, 0}, {0, 0, 0})), expected, "What is in the way?");
    }
    const Color through(0.2, 0.3, 0.4);
    for (const bool lampInside : {false, true}) {
        const Scene scene =
            of({test::lantern(through, test::rho)}, {pointLight({0, lampInside ? 0.5 : 1.5, 0}, intensity)});
        for (const bool eyeInside : {false, true}) {
            Color expected = (lampInside == eyeInside ? test::rho : through) / pi * intensity * 4;
            if (lampInside) expected *= (-0.5 * test::sigma).exp();
            test::expectColor(value(scene, test::meet(scene, {0, eyeInside ? 0.3 : 3, 0}, {0, 1, 0})), expected,
                              "On which side of the surface does the shadow ray start? What is it in there?");
        }
    }
    const test::ForwardPhase phase;
    const Scene scene = of({test::tintedAir({-1, -1, -1}, {1, 1, 1})}, {pointLight({0.6, 0.3, 0.8}, intensity)});
    const Vec3 way(0.6, 0.3, 0.8);
    const Vec3 wo(0.48, 0.6, 0.64);
    const Real p = (1 - wo.dot(way.normalized()) / 2) / (4 * pi);
    test::expectColor(value(scene, Interaction(Vec3::Zero(), wo, phase, scene.mediaAt(Vec3::Zero()))),
                      intensity / way.squaredNorm() * p * (-test::sigma * way.norm()).exp(),
                      "What takes the place of f and of the cosine where a medium scatters?");
}

}  // namespace
}  // namespace caustic
