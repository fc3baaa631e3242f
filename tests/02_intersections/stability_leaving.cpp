#include <gtest/gtest.h>

#include "contact_scene.h"
#include "leaving.h"
#include "math/spawn.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "shape_catalogue.h"

namespace caustic {
namespace {

constexpr Real scales[] = {1e-3, 1, 1e3, 1e6};

// Scenes as large as their coordinates, and scenes of size 1 far from the origin.
Transform scaled(Real scale) {
    return Transform::scaling(Vec3::Constant(scale)) * Transform::translation({0.3, -0.7, 0.5});
}
Transform moved(Real scale) { return Transform::translation(scale * Vec3(0.3, -0.7, 1)); }

void expectNoSelfHits(const Transform& place) {
    const Real size = place.linear()(0, 0);
    for (const CatalogueShape& entry : shapeCatalogue(place)) {
        if (!entry.closed && !entry.convex) continue;  // a group may be hit again, by rights
        const FailureCount count = countSelfHits(*entry.shape, entry.closed, entry.convex, relativeRule(),
                                                 place.point(Vec3::Zero()), 1.5 * size, 5000, 1);
        EXPECT_EQ(count.failures, 0) << entry.name << " of size " << size << " at " << place.translation().transpose()
                                     << ", " << count.trials << " rays";
    }
}

TEST(Leaving, NoShapeIsHitWhereItWasLeftAtAnyScale) {
    for (const Real scale : scales) expectNoSelfHits(scaled(scale));
}

TEST(Leaving, NoShapeIsHitWhereItWasLeftFarFromTheOrigin) {
    for (const Real scale : scales) expectNoSelfHits(moved(scale));
}

TEST(Leaving, ContactGapsAreKept) {
    for (const Real scale : scales) {
        for (const Transform& place : {scaled(scale), moved(scale)}) {
            EXPECT_EQ(countLostContacts(place, 1.0 / 2000, relativeRule(), 20000, 2).failures, 0) << scale;
        }
    }
}

// The offset is 2.3e-13 of the magnitude; a far side that is only ten times as far away is still met.
TEST(Leaving, FarSideBeyondTheOffsetIsMet) {
    for (const Real scale : scales) {
        for (const Real thickness : {1.0 / 2000, 1e-6, 1e-9, 1e-11}) {
            EXPECT_EQ(countLostFarSides(Transform::scaling(Vec3::Constant(scale)), thickness, relativeRule(), 5000, 3)
                          .failures,
                      0)
                << "scale " << scale << ", thickness " << thickness;
        }
    }
}

TEST(Leaving, FixedDistanceFailsAtSomeScale) {
    const FailureCount lost = countLostContacts(scaled(1e-3), 1.0 / 2000, fixedRule(1e-4), 1000, 4);
    EXPECT_EQ(lost.failures, lost.trials);
    const ContactFailures acne = contactFailures<float>(1e3, {1e-4F, 0}, 5000, 4);
    EXPECT_GT(acne.selfHits.failures, 100);
    const ContactFailures fine = contactFailures<double>(1e6, {1e-10, 0}, 5000, 4);
    EXPECT_GT(fine.selfHits.failures, 10);
}

// A shadow ray between two surfaces sees neither of them, however different their sizes are.
TEST(Leaving, ShadowRayMeetsNeitherOfItsEnds) {
    int rays = 0;
    for (const Real ratio : {1.0, 1e-3, 1e-6, 1e6}) {
        const Sphere sphere(ratio * Vec3(0.2, 1.5, 0.1), ratio);
        const Plane floor(Vec3(0.3, 0, 0.2), Vec3(0.1, 1, 0));
        for (int i = 0; i < 5000; ++i) {
            Random random(5, {static_cast<std::uint64_t>(i)});
            const Vec3 above = sphere.center() + 10 * randomDirection(random) * std::max(1.0, ratio);
            const auto ball = sphere.intersect({above, sphere.center() - above});
            const auto ground =
                floor.intersect({random.uniform(-3, 3) * Vec3::UnitX() + 5 * Vec3::UnitY(), -Vec3::UnitY()});
            if (!ball || !ground) continue;
            const Vec3 way = ball->point - ground->point;
            if (way.dot(ground->ng) < 1e-3 * way.norm() || way.dot(ball->ng) > -1e-3 * way.norm()) continue;
            ++rays;
            for (const Ray& ray : {spawnRayTo(*ground, *ball), spawnRayTo(*ball, *ground)}) {
                EXPECT_FALSE(floor.occluded(ray)) << "ratio " << ratio;
                EXPECT_FALSE(sphere.occluded(ray)) << "ratio " << ratio;
            }
        }
    }
    EXPECT_GT(rays, 2000);
}

TEST(Leaving, RayToAPointEndsThere) {
    const Plane floor(Vec3::Zero(), Vec3::UnitY());
    const auto hit = floor.intersect({Vec3(1, 1, 1), Vec3(0, -1, 0)});
    const Vec3 lamp(3, 4, 5);
    const Ray ray = spawnRayTo(*hit, lamp);
    EXPECT_EQ(ray.tMax, 1);
    EXPECT_LE((ray.at(1) - lamp).norm(), 1e-15);
    EXPECT_FALSE(Sphere(lamp + Vec3(0, 1, 0), 0.999).occluded(ray)) << "What is behind the lamp casts no shadow.";
    EXPECT_TRUE(Sphere(Vec3(2, 2, 3), 0.5).occluded(ray));
}

}  // namespace
}  // namespace caustic
