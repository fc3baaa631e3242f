#include <gtest/gtest.h>

#include <numbers>

#include "leaving.h"
#include "shape/box.h"
#include "shape/group.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/sphere.h"

namespace caustic {
namespace {

using ShapePointer = std::shared_ptr<const Shape>;

ShapePointer unitSphere() { return std::make_shared<Sphere>(Vec3::Zero(), 1.0); }

// A sphere scaled by r and moved to c is the sphere around c with radius r.
TEST(Instance, ScaledUnitSphereIsALargerSphere) {
    const Vec3 center(1, -2, 3);
    const Instance instance(unitSphere(), Transform::translation(center) * Transform::scaling(Vec3::Constant(2.5)));
    const Sphere sphere(center, 2.5);
    for (int i = 0; i < 5000; ++i) {
        Random random(1, {static_cast<std::uint64_t>(i)});
        const Ray ray = {center + 6 * randomDirection(random), randomDirection(random)};
        const auto expected = sphere.intersect(ray);
        const auto found = instance.intersect(ray);
        ASSERT_EQ(found.has_value(), expected.has_value());
        if (!found) continue;
        EXPECT_NEAR(found->t, expected->t, 1e-12);
        EXPECT_LE((found->point - expected->point).norm(), 1e-12);
        EXPECT_LE((found->ng - expected->ng).norm(), 1e-12);
        EXPECT_LE((found->dpdu - expected->dpdu).norm(), 1e-11);
        EXPECT_NEAR(found->uv.x(), expected->uv.x(), 1e-12);
    }
}

// The ellipsoid x²/a² + y²/b² + z²/c² = 1 has the normal (x/a², y/b², z/c²).
TEST(Instance, StretchedSphereHasTheEllipsoidsNormals) {
    const Vec3 axes(0.5, 1, 3);
    for (const bool mirrored : {false, true}) {
        const Vec3 factors = mirrored ? Vec3(-axes.x(), axes.y(), axes.z()) : axes;
        const Instance instance(unitSphere(), Transform::scaling(factors));
        for (int i = 0; i < 2000; ++i) {
            Random random(2, {static_cast<std::uint64_t>(i)});
            const Vec3 origin = 5 * randomDirection(random);
            const auto hit = instance.intersect({origin, -origin + randomInBall(random)});
            if (!hit) continue;
            const Vec3 normal = hit->point.cwiseQuotient(axes.cwiseAbs2()).normalized();
            EXPECT_LE((hit->ng - normal).norm(), 1e-12);
        }
    }
}

TEST(Instance, NearestInstanceThatNamesAnObjectWins) {
    const auto hitBy = [](const Shape& shape) { return shape.intersect({Vec3(0, 0, 5), Vec3(0, 0, -1)})->object; };
    const auto unnamed = std::make_shared<Instance>(unitSphere(), Transform());
    const auto inner = std::make_shared<Instance>(unnamed, Transform(), 7);
    const auto between = std::make_shared<Instance>(inner, Transform());
    const Instance outer(between, Transform(), 9);
    EXPECT_EQ(hitBy(*unitSphere()), noObject);
    EXPECT_EQ(hitBy(*unnamed), noObject);
    EXPECT_EQ(hitBy(outer), 7);
    EXPECT_EQ(hitBy(Instance(unnamed, Transform(), 9)), 9);
}

// A hierarchy is only a way of writing: flattened, with all transforms multiplied out, it is hit the same.
TEST(Group, HierarchyHitsWhatTheFlattenedListHits) {
    const auto box = std::make_shared<Box>(Vec3::Constant(-0.5), Vec3::Constant(0.5));
    const auto arm = [&](int i) {
        return Transform::rotation(Vec3::UnitY(), 2 * std::numbers::pi * i / 5) * Transform::translation({2, 0, 0});
    };
    const auto finger = [&](int i) {
        return Transform::translation({0, 0.7 * i, 0}) * Transform::scaling(Vec3(0.6, 0.5, 0.4));
    };
    std::vector<ShapePointer> fingers;
    for (int i = 0; i < 3; ++i) fingers.push_back(std::make_shared<Instance>(box, finger(i)));
    const auto hand = std::make_shared<Group>(fingers);
    std::vector<ShapePointer> arms;
    std::vector<Instance> flat;
    for (int i = 0; i < 5; ++i) {
        arms.push_back(std::make_shared<Instance>(hand, arm(i), i));
        for (int j = 0; j < 3; ++j) flat.emplace_back(box, arm(i) * finger(j), i);
    }
    const Group nested(arms);

    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        Random random(3, {static_cast<std::uint64_t>(i)});
        const Vec3 origin = 5 * randomDirection(random);
        const Ray ray = {origin, 2.5 * randomInBall(random) - origin};
        std::optional<Hit> nearest;
        for (const Instance& member : flat) {
            const auto hit = member.intersect(ray);
            if (hit && (!nearest || hit->t < nearest->t)) nearest = hit;
        }
        const auto found = nested.intersect(ray);
        ASSERT_EQ(found.has_value(), nearest.has_value());
        EXPECT_EQ(nested.occluded(ray), nearest.has_value());
        if (!found) continue;
        ++hits;
        EXPECT_NEAR(found->t, nearest->t, 1e-12);
        EXPECT_EQ(found->object, nearest->object);
        EXPECT_LE((found->ng - nearest->ng).norm(), 1e-12);
    }
    EXPECT_GT(hits, 2000);
}

TEST(Group, WithAPlaneIsUnboundedAndStillHit) {
    const auto plane = std::make_shared<Plane>(Vec3(0, -1, 0), Vec3::UnitY());
    const auto turned = std::make_shared<Instance>(plane, Transform::rotation(Vec3::UnitX(), 0.1));
    const Group group({unitSphere(), turned});
    EXPECT_FALSE(group.bounded());
    EXPECT_FALSE(turned->bounded());
    EXPECT_FALSE(group.bounds().min().allFinite());
    EXPECT_FALSE(group.bounds().min().hasNaN());
    EXPECT_TRUE(group.intersect({Vec3(100, 50, 3), Vec3(0.01, -1, 0)}));
    EXPECT_TRUE(Group({unitSphere()}).bounded());
}

}  // namespace
}  // namespace caustic
