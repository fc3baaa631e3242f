#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "camera/pinhole_camera.h"

namespace caustic {
namespace {

constexpr Real sizes[] = {1e-6, 1, 1e6};

// Looks askew from a place off the origin; 80 × 40 pixels. Its axes as one sees them: up is up in the picture.
struct Place {
    Real size = 1;

    Vec3 position() const { return size * Vec3(3, -7, 2); }
    Vec3 forward() const { return Vec3(2, 1, -2) / 3; }
    Vec3 up() const { return Vec3(1, 2, 2) / 3; }
    Vec3 right() const { return forward().cross(up()); }
    PinholeCamera camera() const {
        return {position(), position() + 5 * size * forward(), 3 * up() + forward(), 0.8, 80, 40};
    }
};

// Whatever the length of the directions: only their angles count here.
Real angleBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

// The field of view is given from the lower to the upper edge, whichever of them is first on the film.
TEST(PinholeCamera, EdgesSpanTheFieldOfView) {
    const PinholeCamera camera = Place{}.camera();
    const Vec3 first = camera.sampleRay({40, 0}, Vec2::Zero()).direction;
    const Vec3 last = camera.sampleRay({40, 40}, Vec2::Zero()).direction;
    EXPECT_NEAR(angleBetween(first, last), 0.8, 1e-12) << "How high is the film at distance 1?";
    EXPECT_NEAR(angleBetween(first, Place{}.forward()), 0.4, 1e-12) << "Is the middle of the film in the middle?";
    EXPECT_NEAR(angleBetween(camera.sampleRay({40, 20}, Vec2::Zero()).direction, Place{}.forward()), 0, 1e-12)
        << "Is the middle of the film in the middle?";
}

// Film coordinates are an image's: y grows downwards.
TEST(PinholeCamera, TheFirstRowShowsWhatIsAbove) {
    const Place place;
    const PinholeCamera camera = place.camera();
    EXPECT_GT(camera.sampleRay({40, 1}, Vec2::Zero()).direction.dot(place.up()), 0)
        << "Which way does y go on the film?";
    EXPECT_LT(camera.sampleRay({40, 39}, Vec2::Zero()).direction.dot(place.up()), 0);
    EXPECT_GT(camera.sampleRay({79, 20}, Vec2::Zero()).direction.dot(place.right()), 0) << "Which way does x go?";
}

// 20 pixels to the right and 20 pixels up are the same angle, also on a film that isn't square; and as many pixels in a
// row are as far from each other everywhere on the film, beyond its edges, too.
TEST(PinholeCamera, PixelsAreSquare) {
    const Place place;
    const PinholeCamera camera = place.camera();
    const Vec3 middle = camera.sampleRay({40, 20}, Vec2::Zero()).direction;
    const Real sideways = angleBetween(middle, camera.sampleRay({60, 20}, Vec2::Zero()).direction);
    const Real upwards = angleBetween(middle, camera.sampleRay({40, 0}, Vec2::Zero()).direction);
    EXPECT_NEAR(sideways, upwards, 1e-12) << "Is the width of the film in the same unit as its height?";
    const auto onFilm = [&](Real x, Real y) -> Vec2 {
        const Vec3 direction = camera.sampleRay({x, y}, Vec2::Zero()).direction;
        return Vec2(direction.dot(place.right()), direction.dot(place.up())) / direction.dot(place.forward());
    };
    for (const Vec2& film : {Vec2(0, 0), Vec2(71.25, 3.5), Vec2(80, 40), Vec2(-7, 33.75), Vec2(12.5, 46)}) {
        const Vec2 step = onFilm(film.x() + 1, film.y() + 1) - onFilm(film.x(), film.y());
        EXPECT_NEAR(std::abs(step.x() / step.y()), 1, 1e-9) << "One pixel to the right and one down?";
        EXPECT_NEAR((onFilm(film.x() + 20, film.y()) - onFilm(film.x(), film.y())).x(), std::abs(onFilm(40, 0).y()),
                    1e-12)
            << "Is the film flat, with pixels of one size?";
    }
}

// Rays start in the pinhole, whatever its place, and their directions are unit.
TEST(PinholeCamera, DirectionsAreUnit) {
    for (const Real size : sizes) {
        const Place place = {size};
        const PinholeCamera camera = place.camera();
        for (const Vec2& film : {Vec2(3, 5), Vec2(71.25, 3.5), Vec2(-7, 46)}) {
            const Ray ray = camera.sampleRay(film, {0.3, 0.9});
            EXPECT_NEAR(ray.direction.norm(), 1, 1e-14) << "How long is the ray's direction?";
            EXPECT_TRUE(ray.origin == place.position()) << "Where does light come in?";
        }
    }
}

}  // namespace
}  // namespace caustic
