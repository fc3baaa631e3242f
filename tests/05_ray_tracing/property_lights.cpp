#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "light/area_light.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/direction_chi_square.h"
#include "support/in_cube.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

std::vector<std::shared_ptr<Light>> someLights() {
    const auto rectangle = std::make_shared<Rectangle>(Vec3(-1, 3, -1), Vec3(2, 0, 0), Vec3(0, 0, 3));
    const auto sphere = std::make_shared<Sphere>(Vec3(2, 2, 2), 0.5);
    const auto white = std::make_shared<ConstantTexture>(Color(1, 2, 3));
    std::vector<std::shared_ptr<Light>> lights = {
        std::make_shared<PointLight>(Vec3(1, 2, 3), Color(1, 2, 3)),
        std::make_shared<ConeLight>(Vec3(1, 2, 3), Vec3(-1, -2, -3), 0.6, Color(1, 2, 3)),
        std::make_shared<AreaLight>(rectangle, white), std::make_shared<AreaLight>(sphere, white),
        std::make_shared<ConstantEnvironment>(Color(1, 2, 3))};
    for (const auto& light : lights) light->prepare({Vec3(-2, -1, -3), Vec3(1, 4, 2)});
    return lights;
}

// Light tracing's weights: their mean is the light's power, and each states its own densities.
TEST(Light, EmissionCarriesItsPower) {
    for (const auto& light : someLights()) {
        Real sum = 0;
        Real squares = 0;
        constexpr int n = 20'000;
        for (int i = 0; i < n; ++i) {
            Random random(6, {static_cast<std::uint64_t>(i)});
            const Real a = random.uniform();
            const Real b = random.uniform();
            const Real c = random.uniform();
            const auto sample = light->sampleEmission({a, b}, {c, random.uniform()});
            ASSERT_TRUE(sample);
            SurfacePoint at;
            at.point = sample->ray.origin;
            at.ng = sample->ng;
            const EmissionPdf pdf = light->pdfEmission(at, sample->ray.direction);
            EXPECT_NEAR(pdf.pdfW, sample->pdfW, 1e-9 * sample->pdfW);
            EXPECT_NEAR(light->deltaPlace() ? 1 : pdf.pdfA, sample->pdfA, 1e-9 * sample->pdfA);
            const Real cosine = std::abs(sample->ng.dot(sample->ray.direction));
            const Real carried = sample->radiance.y() * cosine / (sample->pdfA * sample->pdfW);
            sum += carried;
            squares += carried * carried;
        }
        const Real mean = sum / n;
        const Real error = std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
        EXPECT_NEAR(mean, light->power().y(), 4.9 * error + 1e-9 * mean);
    }
}

TEST(Light, PowersMatchTheirClosedForms) {
    const auto lights = someLights();
    EXPECT_NEAR(lights[0]->power().x(), 4 * pi, 1e-12);
    EXPECT_NEAR(lights[1]->power().x(), 2 * pi * (1 - std::cos(0.6)), 1e-12);
    EXPECT_NEAR(lights[2]->power().x(), pi * 6, 1e-12);
    EXPECT_NEAR(lights[3]->power().x(), pi * 4 * pi * 0.25, 1e-12);
    EXPECT_NEAR(lights[4]->power().x(), pi * pi * (9 + 25 + 25), 1e-9);
}

// What sampleDirect picks has the density that pdfW states, and what it brings is what the light sends out.
TEST(Light, DirectSamplesAgreeWithTheirDensity) {
    for (const auto& light : someLights()) {
        int seen = 0;
        for (std::uint64_t i = 0; i < 2000; ++i) {
            Random random(7, {i});
            SurfacePoint from;
            from.point = 0.9 * test::inCube(random);
            from.ng = test::inCube(random).normalized();
            from.magnitude = 1;
            const Real x = random.uniform();
            const auto sample = light->sampleDirect(from, {x, random.uniform()});
            if (!sample) continue;
            ++seen;
            EXPECT_NEAR(sample->wi.norm(), 1, 1e-12);
            EXPECT_NEAR(sample->ray.direction.normalized().dot(sample->wi), 1, 1e-9);
            if (!light->infinite()) {
                EXPECT_LE((from.point + (sample->on.point - from.point).norm() * sample->wi - sample->on.point).norm(),
                          1e-12);
            }
            if (light->deltaPlace()) {
                EXPECT_EQ(sample->pdfW, 1);
            } else if (!light->infinite()) {
                EXPECT_NEAR(light->pdfW(from.point, sample->on) / sample->pdfW, 1, 1e-12);
                EXPECT_TRUE((light->Le(sample->on, -sample->wi) == sample->radiance).all());
            } else {
                EXPECT_NEAR(light->pdfW(from.point, sample->wi), sample->pdfW, 1e-12);
                EXPECT_TRUE((light->Le(sample->ray) == sample->radiance).all());
                EXPECT_TRUE(std::isinf(sample->ray.tMax));
            }
        }
        EXPECT_GT(seen, 100);
    }
}

}  // namespace
}  // namespace caustic
