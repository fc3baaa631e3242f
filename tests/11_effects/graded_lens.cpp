#include <gtest/gtest.h>

#include <cmath>

#include "camera/thin_lens_camera.h"
#include "core/random.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

const Vec3 eye(3, -2, 1.5);
const Vec3 target(-1, 0.5, 0.2);
const Vec3 up(0.1, 0.2, 1);
constexpr Real fieldOfView = 0.9;
constexpr int width = 37;
constexpr int height = 20;

ThinLensCamera camera(Real radius, Real focus) { return {eye, target, up, fieldOfView, width, height, radius, focus}; }

Vec2 pairOf(Random& random) {
    const Real x = random.uniform();
    return {x, random.uniform()};
}

// Whatever point of the lens: where the pinhole's ray meets the plane in focus, all rays of a film point do.
TEST(ThinLens, RaysOfAFilmPointMeetInFocus) {
    Random random(21, {1});
    const PinholeCamera pinhole(eye, target, up, fieldOfView, width, height);
    const Vec3 view = (target - eye).normalized();
    for (int i = 0; i < 1000; ++i) {
        const Real focus = std::pow(10, random.uniform(-1, 2));
        const ThinLensCamera lens = camera(random.uniform(0.01, 0.5) * focus, focus);
        const Vec2 film = pairOf(random).cwiseProduct(Vec2(width, height));
        const Ray middle = pinhole.sampleRay(film, {0.5, 0.5});
        const Vec3 inFocus = eye + middle.direction * (focus / middle.direction.dot(view));
        const Ray ray = lens.sampleRay(film, pairOf(random));
        ASSERT_NEAR(ray.direction.norm(), 1, 1e-12) << "Rays have unit directions.";
        const Vec3 reached = ray.at((inFocus - ray.origin).norm());
        ASSERT_LT((reached - inFocus).norm(), 1e-9 * focus)
            << "Where do the rays of one film point meet: on a plane, or on a ball around the lens?";
    }
}

// Origins are spread evenly over a disc of that radius that faces the view: of x and y, the mean square is r²/4; half
// of them are within r/√2.
TEST(ThinLens, LensPointsAreEvenOnTheDisc) {
    Random random(21, {2});
    constexpr Real radius = 0.3;
    const ThinLensCamera lens = camera(radius, 4);
    const Vec3 view = (target - eye).normalized();
    constexpr int draws = 40'000;
    Real squares = 0;
    int within = 0;
    for (int i = 0; i < draws; ++i) {
        const Ray ray = lens.sampleRay({11.3, 4.2}, pairOf(random));
        const Vec3 offset = ray.origin - eye;
        ASSERT_LE(offset.norm(), radius * (1 + 1e-12)) << "Is the radius a diameter?";
        ASSERT_NEAR(offset.dot(view), 0, 1e-12) << "The lens faces the view.";
        squares += offset.squaredNorm();
        within += offset.norm() < radius / std::sqrt(2) ? 1 : 0;
    }
    EXPECT_NEAR(squares / draws / (radius * radius), 0.5, 0.01) << "Is the lens's middle hit too often?";
    EXPECT_NEAR(within / Real(draws), 0.5, 0.0125);
}

// Radius 0: the pinhole's rays to the last bit.
TEST(ThinLens, WithoutALensItIsThePinhole) {
    Random random(21, {3});
    const PinholeCamera pinhole(eye, target, up, fieldOfView, width, height);
    for (int i = 0; i < 1000; ++i) {
        const ThinLensCamera lens = camera(0, random.uniform(0.1, 50));
        const Vec2 film = pairOf(random).cwiseProduct(Vec2(width, height));
        const Vec2 u = pairOf(random);
        const Ray ray = lens.sampleRay(film, u);
        ASSERT_EQ(ray.origin, pinhole.sampleRay(film, u).origin);
        ASSERT_EQ(ray.direction, pinhole.sampleRay(film, u).direction)
            << "Bit for bit: is a unit vector normalised once more?";
    }
}

}  // namespace
}  // namespace caustic
