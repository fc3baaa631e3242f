#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "light/area_light.h"
#include "math/frame.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/form_factor.h"
#include "support/in_cube.h"
#include "texture/checker_texture.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real sizes[] = {1e-6, 1, 1e6};

// Faces down, at y = 1.5.
const std::shared_ptr<const Shape> lamp =
    std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));

// A lamp that is turned anyhow, off the origin; its corner is far from it.
std::shared_ptr<const Shape> turnedLamp(Real size) {
    const Frame frame = Frame::around(Vec3(0.36, -0.48, 0.8));
    return std::make_shared<Rectangle>(size * Vec3(5, -3, 2), 2 * size * frame.s, size * frame.t);
}

SurfacePoint onFloor(Real x, Real z) {
    SurfacePoint from;
    from.point = Vec3(x, 0, z);
    from.ng = Vec3::UnitY();
    from.magnitude = 2;
    return from;
}

// A point of a ball of that radius that lies before the turned lamp, on the side that faces it.
SurfacePoint onBall(const Sphere& ball, Random& random) {
    const Vec3 outward = (Vec3(0.36, -0.48, 0.8) * -0.9 + 0.4 * test::inCube(random)).normalized();
    SurfacePoint from;
    from.point = ball.center() + ball.radius() * outward;
    from.ng = outward;
    from.magnitude = from.point.cwiseAbs().maxCoeff() + ball.radius();
    return from;
}

// Irradiance E = ∫ L cos θ dω = π L F with the form factor in closed form: the mean of L cos θ / pdf.
TEST(AreaLight, SamplesAddUpToTheFormFactor) {
    const Color radiance(3, 1, 2);
    const AreaLight light(lamp, std::make_shared<ConstantTexture>(radiance));
    for (const Real x : {0.0, 2.5}) {
        const SurfacePoint from = onFloor(x, 0.2);
        const Color expected = radiance * pi * test::formFactor(-1 - x, 1 - x, -0.7, 0.3, 1.5);
        Color sum = Color::Zero();
        constexpr int n = 40'000;
        for (int i = 0; i < n; ++i) {
            Random random(1, {static_cast<std::uint64_t>(i)});
            const Real u = (i % 200 + random.uniform()) / 200;
            const auto sample = light.sampleDirect(from, {u, (i / 200 + random.uniform()) / 200});
            ASSERT_TRUE(sample);
            sum += sample->radiance * std::abs(sample->wi.y()) / sample->pdfW;
            if (i % 100 != 0) continue;
            EXPECT_NEAR(sample->pdfW / light.pdfW(from.point, sample->on), 1, 1e-12)
                << "Is the density that of this direction, to the last digits?";
        }
        // Jittered in 200 × 200 cells: the error is far below a thousandth.
        EXPECT_LE((sum / n / expected - 1).abs().maxCoeff(), 1e-3)
            << "Has the density over area become one over solid angle: by distance squared and the lamp's cosine?";
    }
}

// What a sample says is about one and the same point of the lamp: where it is, how it shines there, the direction to
// it. At any size, from where nothing is, too.
TEST(AreaLight, ASampleIsOfOnePoint) {
    const auto checks = std::make_shared<CheckerTexture>(Color(3, 1, 2), Color(1, 5, 0.5), 0.13);
    for (const Real size : sizes) {
        const auto shape = turnedLamp(size);
        const AreaLight light(shape, checks);
        Vec3 mean = Vec3::Zero();
        for (std::uint64_t i = 0; i < 1000; ++i) {
            Random random(3, {i});
            SurfacePoint from;
            from.point = size * (Vec3(6, -5, 5) + test::inCube(random));
            from.magnitude = 0;
            const Real u = random.uniform();
            const auto sample = light.sampleDirect(from, {u, random.uniform()});
            ASSERT_TRUE(sample) << "Which side does the lamp shine to?";
            const Vec3 way = sample->on.point - from.point;
            EXPECT_LE((sample->wi - way.normalized()).norm(), 1e-12) << "Is wi unit, from the point to the light?";
            EXPECT_LE((sample->on.ng - Vec3(0.36, -0.48, 0.8)).norm(), 1e-12) << "Which point of the lamp is it?";
            EXPECT_TRUE((sample->radiance == checks->at(sample->on)).all()) << "How does the lamp shine there?";
            mean += sample->on.point / size / 1000;
        }
        const Frame frame = Frame::around(Vec3(0.36, -0.48, 0.8));
        EXPECT_LE((mean - Vec3(5, -3, 2) - frame.s - 0.5 * frame.t).norm(), 0.11) << "Is every point as likely?";
    }
}

// The back of the lamp sends nothing; nor does it in its own plane, nor to the very point that was picked.
TEST(AreaLight, ItsBackIsDark) {
    const AreaLight light(lamp, std::make_shared<ConstantTexture>(Color::Ones()));
    SurfacePoint from = onFloor(0, 0);
    for (const Real height : {3.0, 1.5 + 1e-9, 1.5}) {
        for (const Real x : {0.0, 0.9, 4.0}) {
            from.point = Vec3(x, height, 0.1);
            EXPECT_FALSE(light.sampleDirect(from, {0.3, 0.4})) << "Which side does the lamp's normal point to?";
        }
    }
    from.point = Vec3(0.3, 1, 0.1);
    from.point = light.sampleDirect(from, {0.3, 0.4})->on.point;
    EXPECT_FALSE(light.sampleDirect(from, {0.3, 0.4})) << "What is the direction to a point that one is at?";
}

// The lamp must not shadow itself, nor may anything behind it; nor the surface from which the lamp is seen.
TEST(AreaLight, ShadowRayEndsBeforeTheLamp) {
    for (const Real size : sizes) {
        const auto shape = turnedLamp(size);
        const AreaLight light(shape, std::make_shared<ConstantTexture>(Color::Ones()));
        const Sphere ball(size * Vec3(7, -5, 6), 0.7 * size);
        for (std::uint64_t i = 0; i < 1000; ++i) {
            Random random(2, {i});
            const SurfacePoint from = onBall(ball, random);
            const Real u = random.uniform();
            const auto sample = light.sampleDirect(from, {u, random.uniform()});
            ASSERT_TRUE(sample);
            if (sample->wi.dot(from.ng) < 0.05) continue;
            ASSERT_FALSE(shape->occluded(sample->ray)) << "Where does the shadow ray end?";
            ASSERT_FALSE(ball.occluded(sample->ray)) << "Where does the shadow ray start?";
            EXPECT_LE((sample->ray.at(sample->ray.tMax) - sample->on.point).norm(), 1e-10 * size)
                << "Does it go all the way?";
            EXPECT_LE((sample->ray.at(0) - from.point).norm(), 1e-10 * size) << "Does it start where light arrives?";
        }
    }
}

}  // namespace
}  // namespace caustic
