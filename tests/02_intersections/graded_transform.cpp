#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>

#include "math/transform.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// Two tangents span the surface before and after; the normal stays perpendicular to both.
TEST(Transform, NormalStaysPerpendicularToTheSurface) {
    const Transform uneven = Transform::rotation({1, 2, 3}, 0.7) * Transform::scaling({2, 1, 0.25});
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(1, {i});
        const Vec3 u = inCube(random);
        const Vec3 v = inCube(random);
        const Vec3 normal = uneven.normal(u.cross(v).normalized()).normalized();
        EXPECT_NEAR(normal.dot(uneven.vector(u).normalized()), 0, 1e-12)
            << "A flattened sphere: do its normals move towards the flattened axis or away from it?";
        EXPECT_NEAR(normal.dot(uneven.vector(v).normalized()), 0, 1e-12);
    }
}

// What was outside before is outside after, in a mirror too: a step along the old normal maps to the new normal's side.
TEST(Transform, NormalIsUnitAndStaysOnItsSide) {
    for (const Real factor : {2.0, -2.0}) {
        const Transform transform = Transform::rotation({1, -1, 2}, 2) * Transform::scaling({factor, 2, 2});
        for (std::uint64_t i = 0; i < 1000; ++i) {
            Random random(2, {i});
            const Vec3 n = inCube(random).normalized();
            const Vec3 normal = transform.normal(n);
            EXPECT_NEAR(normal.norm(), 1, 1e-14) << "Is the result unit?";
            EXPECT_GT(normal.dot(transform.vector(n)), 0) << "Does the determinant's sign matter here?";
        }
    }
}

// The plane z = 1 in a space that is twice as large: a ray of any length reaches it at the t that world space says.
TEST(Instance, TMeansTheSameInBothSpaces) {
    const auto plane = std::make_shared<Plane>(Vec3(0, 0, 1), Vec3::UnitZ());
    const Instance instance(plane, Transform::translation({5, -3, 1}) * Transform::scaling(Vec3::Constant(2)));
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Ray ray = {3 * inCube(random) + Vec3(0, 0, 10),
                         random.uniform(0.1, 10) * (inCube(random) - Vec3(0, 0, 2))};
        const Real t = (3 - ray.origin.z()) / ray.direction.z();  // the plane stands at z = 2 · 1 + 1
        const auto hit = instance.intersect(ray);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, t, 1e-12) << "Was the direction normalised on the way?";
        EXPECT_LE((hit->point - ray.at(t)).norm(), 1e-11);
    }
}

TEST(Instance, InnermostNameWins) {
    const auto plane = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitZ());
    const Ray ray = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
    const auto unnamed = std::make_shared<Instance>(plane, Transform());
    const auto inner = std::make_shared<Instance>(unnamed, Transform(), 3);
    EXPECT_EQ(unnamed->intersect(ray)->object, noObject);
    EXPECT_EQ(inner->intersect(ray)->object, 3);
    EXPECT_EQ(Instance(inner, Transform(), 5).intersect(ray)->object, 3) << "Does the outer instance overwrite?";
    EXPECT_EQ(Instance(inner, Transform()).intersect(ray)->object, 3);
}

// A turned plane has turned tangents and a turned shading normal: those of the plane, taken through the rotation.
TEST(Instance, TangentsAndShadingNormalTurnWithTheShape) {
    const auto plane = std::make_shared<Plane>(Vec3::Zero(), Vec3(1, 2, 3));
    const Transform turn = Transform::rotation({1, 1, -1}, 1.2);
    const Instance instance(plane, turn);
    const Ray ray = {Vec3(1, 2, 3), Vec3(-1, -2, -3)};
    const auto before = plane->intersect(ray);
    const auto after = instance.intersect(turn.ray(ray));
    ASSERT_TRUE(before && after);
    EXPECT_LE((after->dpdu - turn.vector(before->dpdu)).norm(), 1e-14) << "Is dpdu a direction in world space?";
    EXPECT_LE((after->dpdv - turn.vector(before->dpdv)).norm(), 1e-14);
    EXPECT_LE((after->ns - turn.vector(before->ns)).norm(), 1e-14) << "Is ns still the shape's own?";
    EXPECT_LE((after->ng - turn.vector(before->ng)).norm(), 1e-14);
}

}  // namespace
}  // namespace caustic
