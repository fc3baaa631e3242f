#include <gtest/gtest.h>

#include <memory>

#include "math/spawn.h"
#include "shape/plane.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// A tilted plane at four scales: a ray that leaves it upwards doesn't meet it, nor does it start beyond something that
// is 1/2000 of the scale away.
TEST(Leaving, ClearsTheSurfaceAndKeepsContactGapsAtEveryScale) {
    for (const Real scale : {1e-3, 1.0, 1e3, 1e6}) {
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
}

// A ray that goes through the surface (refraction) starts on the far side of it.
TEST(Leaving, StartsOnTheSideThatTheDirectionGoesTo) {
    const SurfacePoint at = {Vec3(1, 2, 3), Vec3(0, 0.6, 0.8), Vec2::Zero(), 3};
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Vec3 direction = inCube(random);
        const Real height = (spawnRay(at, direction).origin - at.point).dot(at.ng);
        ASSERT_GT(height * direction.dot(at.ng), 0) << "Which way does a refracted ray leave?";
    }
}

}  // namespace
}  // namespace caustic
