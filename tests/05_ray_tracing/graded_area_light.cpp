#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "light/area_light.h"
#include "shape/rectangle.h"
#include "support/form_factor.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

// Faces down, at y = 1.5.
const std::shared_ptr<const Shape> lamp =
    std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));

SurfacePoint onFloor(Real x, Real z) {
    SurfacePoint from;
    from.point = Vec3(x, 0, z);
    from.ng = Vec3::UnitY();
    from.magnitude = 2;
    return from;
}

// Irradiance E = ∫ L cos θ dω = π L F with the form factor in closed form: the mean of L cos θ / pdf.
TEST(AreaLight, SamplesAddUpToTheFormFactor) {
    const AreaLight light(lamp, std::make_shared<ConstantTexture>(Color::Constant(3)));
    for (const Real x : {0.0, 2.5}) {
        const SurfacePoint from = onFloor(x, 0.2);
        const Real expected = 3 * pi * test::formFactor(-1 - x, 1 - x, -0.7, 0.3, 1.5);
        Real sum = 0;
        constexpr int n = 40'000;
        for (int i = 0; i < n; ++i) {
            Random random(1, {static_cast<std::uint64_t>(i)});
            const Real u = (i % 200 + random.uniform()) / 200;
            const auto sample = light.sampleDirect(from, {u, (i / 200 + random.uniform()) / 200});
            ASSERT_TRUE(sample);
            sum += sample->radiance.x() * std::abs(sample->wi.y()) / sample->pdfW;
        }
        // Jittered in 200 × 200 cells: the error is far below a thousandth.
        EXPECT_NEAR(sum / n, expected, 1e-3 * expected)
            << "Has the density over area become one over solid angle: by distance squared and the lamp's cosine?";
    }
}

// The back of the lamp sends nothing.
TEST(AreaLight, ItsBackIsDark) {
    const AreaLight light(lamp, std::make_shared<ConstantTexture>(Color::Ones()));
    SurfacePoint above = onFloor(0, 0);
    above.point.y() = 3;
    EXPECT_FALSE(light.sampleDirect(above, {0.3, 0.4})) << "Which side does the lamp's normal point to?";
}

// The lamp must not shadow itself, nor may anything behind it.
TEST(AreaLight, ShadowRayEndsBeforeTheLamp) {
    const AreaLight light(lamp, std::make_shared<ConstantTexture>(Color::Ones()));
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Real u = random.uniform();
        const auto sample = light.sampleDirect(onFloor(random.uniform(-3, 3), 0.1), {u, random.uniform()});
        ASSERT_TRUE(sample);
        EXPECT_FALSE(lamp->occluded(sample->ray)) << "Where does the shadow ray end?";
        EXPECT_GT(sample->ray.at(sample->ray.tMax).y(), 1.49) << "Does it go all the way?";
    }
}

}  // namespace
}  // namespace caustic
