#include <gtest/gtest.h>

#include <cmath>

#include "camera/pinhole_camera.h"

namespace caustic {
namespace {

// Looks along −z, y is up; 80 × 40 pixels.
PinholeCamera wideCamera() { return {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY(), 0.8, 80, 40}; }

// Whatever the length of the directions: only their angles count here.
Real angleBetween(const Vec3& a, const Vec3& b) { return std::acos(a.dot(b) / (a.norm() * b.norm())); }

// The field of view is given from the lower to the upper edge, whichever of them is first on the film.
TEST(PinholeCamera, EdgesSpanTheFieldOfView) {
    const PinholeCamera camera = wideCamera();
    const Vec3 first = camera.sampleRay({40, 0}, {}).direction;
    const Vec3 last = camera.sampleRay({40, 40}, {}).direction;
    EXPECT_NEAR(angleBetween(first, last), 0.8, 1e-12) << "How high is the film at distance 1?";
    EXPECT_NEAR(angleBetween(first, -Vec3::UnitZ()), 0.4, 1e-12) << "Is the middle of the film in the middle?";
}

// Film coordinates are an image's: y grows downwards.
TEST(PinholeCamera, TheFirstRowShowsWhatIsAbove) {
    const PinholeCamera camera = wideCamera();
    EXPECT_GT(camera.sampleRay({40, 1}, {}).direction.y(), 0) << "Which way does y go on the film?";
    EXPECT_LT(camera.sampleRay({40, 39}, {}).direction.y(), 0);
    EXPECT_GT(camera.sampleRay({79, 20}, {}).direction.x(), 0);
}

// 20 pixels to the right and 20 pixels up are the same angle, also on a film that isn't square.
TEST(PinholeCamera, PixelsAreSquare) {
    const PinholeCamera camera = wideCamera();
    const Vec3 middle = camera.sampleRay({40, 20}, {}).direction;
    const Real sideways = angleBetween(middle, camera.sampleRay({60, 20}, {}).direction);
    const Real upwards = angleBetween(middle, camera.sampleRay({40, 0}, {}).direction);
    EXPECT_NEAR(sideways, upwards, 1e-12) << "Is the width of the film in the same unit as its height?";
}

TEST(PinholeCamera, DirectionsAreUnit) {
    EXPECT_NEAR(wideCamera().sampleRay({3, 5}, {}).direction.norm(), 1, 1e-14) << "How long is the ray's direction?";
}

}  // namespace
}  // namespace caustic
