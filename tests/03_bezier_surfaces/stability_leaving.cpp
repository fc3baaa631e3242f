#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "math/spawn.h"
#include "revolution_cases.h"
#include "shape/instance.h"

namespace caustic {
namespace {

// Rays that leave the surface at random places, half of them so that no other place of their line is nearer to the axis
// (there a distance along the line grows with the root of an error of the radius), down to 1e-8 from the tangent plane.
struct Departures {
    int tried = 0;
    // Met at once from the side that they left to: they can't have crossed the surface between. (Far away they may: a
    // profile with a loop is met twice from within.)
    int wrong = 0;
};

Vec3 awayFrom(const SurfacePoint& at, bool nearestToAxis, Random& random) {
    const Real lean = std::pow(10.0, -8 * random.uniform());
    const Real side = random.uniform() < 0.5 ? -1 : 1;
    const Vec3 outward = Vec3(at.point.x(), 0, at.point.z()).normalized();
    const Vec3 around(-outward.z(), 0, outward.x());
    if (nearestToAxis) return (around + side * lean * Vec3::UnitY()).normalized();
    const Real angle = 2 * std::numbers::pi * random.uniform();
    const Vec3 tangent = (at.ng.cross(around).normalized() * std::sin(angle) + around * std::cos(angle)).normalized();
    return (tangent + side * lean * at.ng).normalized();
}

Departures depart(const std::vector<BezierCurve>& profile, const Transform& place, int rays, std::uint64_t seed) {
    const auto surface = std::make_shared<SurfaceOfRevolution>(profile);
    const Instance instance(surface, place);
    Departures count;
    for (int i = 0; i < rays; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const std::optional<AreaSample> sample = surface->sampleArea({random.uniform(), random.uniform()});
        if (!sample) continue;
        const Vec3 local = awayFrom(sample->at, i % 2 == 0, random);
        // From a hit, as a renderer leaves it: a ray along the normal finds the place in the instance.
        const Vec3 normal = place.normal(sample->at.ng).normalized();
        const Vec3 point = place.point(sample->at.point);
        const Real size = place.linear().norm() * surface->bounds().diagonal().norm();
        const std::optional<Hit> from = instance.intersect({point + 1e-3 * size * normal, -normal});
        if (!from) continue;
        const Vec3 direction = place.vector(local).normalized();
        const std::optional<Hit> next = instance.intersect(spawnRay(*from, direction));
        ++count.tried;
        if (!next || next->t > 1e-7 * size) continue;
        const bool leavesOutwards = direction.dot(from->ng) > 0;
        count.wrong += (direction.dot(next->ng) > 0) == leavesOutwards ? 1 : 0;
    }
    return count;
}

TEST(LeavingRevolution, NoRayMeetsTheSurfaceFromTheSideThatItLeftTo) {
    const Transform places[] = {Transform::scaling(Vec3::Constant(1)), Transform::translation({2.3, 0.0625, -4.1}),
                                Transform::translation({-310, 77, 120}) * Transform::scaling(Vec3::Constant(1e3)),
                                Transform::rotation({0.3, 1, -0.2}, 0.7) * Transform::scaling(Vec3::Constant(1e-4))};
    for (const NamedProfile& one : difficultProfiles()) {
        for (std::size_t p = 0; p < std::size(places); ++p) {
            const Departures count = depart(one.profile, places[p], 5000, 11 + p);
            EXPECT_GT(count.tried, 2000) << one.name;
            EXPECT_EQ(count.wrong, 0) << one.name << " at place " << p << ", of " << count.tried
                                      << " rays. Where along its line does a ray come nearest to the axis?";
        }
    }
}

}  // namespace
}  // namespace caustic
