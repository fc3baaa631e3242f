#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>

#include "math/spawn.h"
#include "shape/plane.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// A tilted plane at several scales: a ray that leaves it upwards doesn't meet it, nor does it start beyond something
// that is 1/2000 of the scale away.
TEST(Leaving, ClearsTheSurfaceAndKeepsContactGapsAtEveryScale) {
    for (const Real scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        const Plane plane(scale * Vec3(0.3, -0.7, 0.5), Vec3(1, 7, 3));
        for (std::uint64_t i = 0; i < 5000; ++i) {
            Random random(1, {i});
            const Vec3 origin = scale * (inCube(random) + Vec3(1, 9, 3));
            const auto hit = plane.intersect({origin, scale * inCube(random) - origin});
            if (!hit) continue;
            Vec3 direction = inCube(random);
            if (direction.dot(hit->ng) < 0) direction = -direction;
            const Ray ray = spawnRay(*hit, direction);
            ASSERT_FALSE(plane.occluded(ray)) << "scale " << scale << ": is the offset in proportion to the magnitude?";
            ASSERT_LT((ray.origin - hit->point).norm(), scale / 2000)
                << "scale " << scale << ": is the offset in proportion to the magnitude?";
        }
    }
    // The magnitude that is asked for may be larger than the point's own: that of a large thing beside a small one.
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Real scale = std::pow(10, random.uniform(-6, 6));
        const Vec3 point = scale * inCube(random);
        const SurfacePoint at = {point, inCube(random).normalized(), Vec2::Zero(), point.cwiseAbs().maxCoeff()};
        const Real magnitude = at.magnitude * random.uniform(1e4, 1e5);
        const Vec3 direction = inCube(random);
        const Vec3 moved = offsetPoint(at, direction, magnitude) - point;
        ASSERT_NEAR(moved.norm(), surfaceOffset * magnitude, 1e-3 * surfaceOffset * magnitude)
            << "Whose magnitude is it, the point's or the one that is handed in?";
        ASSERT_NEAR(std::abs(moved.normalized().dot(at.ng)), 1, 1e-6) << "Along which direction is it moved?";
        const SurfacePoint origin = {Vec3::Zero(), at.ng, Vec2::Zero(), 0};
        ASSERT_NEAR(offsetPoint(origin, direction, magnitude).norm(), surfaceOffset * magnitude,
                    1e-12 * surfaceOffset * magnitude);
    }
}

// A ray that goes through the surface (refraction) starts on the far side of it, one along the surface outside.
TEST(Leaving, StartsOnTheSideThatTheDirectionGoesTo) {
    const SurfacePoint at = {Vec3(1, 2, 3), Vec3(0, 0.6, 0.8), Vec2::Zero(), 3};
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Vec3 direction = std::pow(10, random.uniform(-6, 6)) * inCube(random);
        const Real height = (spawnRay(at, direction).origin - at.point).dot(at.ng);
        ASSERT_GT(height * direction.dot(at.ng), 0) << "Which way does a refracted ray leave?";
    }
    const SurfacePoint level = {Vec3(1, 2, 3), Vec3(0, 0, 1), Vec2::Zero(), 3};
    for (const Vec3& along : {Vec3(1, 2, 0), Vec3(-1, 2, -0.0)}) {
        EXPECT_GT(spawnRay(level, along).origin.z(), 3) << "On which side of the surface is a tangent?";
    }
}

}  // namespace
}  // namespace caustic
