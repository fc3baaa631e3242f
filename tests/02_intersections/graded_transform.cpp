#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <memory>

#include "math/transform.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// Any regular map: turned, sheared, mirrored every other time, of any size, moved far away.
Transform anyTransform(std::uint64_t i) {
    Random random(7, {i});
    const Real size = std::pow(10, random.uniform(-6, 6));
    Mat3 linear;
    do {
        for (int column = 0; column < 3; ++column) linear.col(column) = inCube(random);
    } while (std::abs(linear.determinant()) < 0.1);
    return {size * linear, 10 * size * inCube(random)};
}

// Two tangents span the surface before and after; the normal stays perpendicular to both.
TEST(Transform, NormalStaysPerpendicularToTheSurface) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Transform transform = anyTransform(i);
        Random random(1, {i});
        const Vec3 u = inCube(random);
        const Vec3 v = inCube(random);
        const Vec3 normal = transform.normal(u.cross(v).normalized()).normalized();
        ASSERT_NEAR(normal.dot(transform.vector(u).normalized()), 0, 1e-11)
            << "A flattened sphere: do its normals move towards the flattened axis or away from it?";
        ASSERT_NEAR(normal.dot(transform.vector(v).normalized()), 0, 1e-11);
    }
}

// What was outside before is outside after, in a mirror too: a step along the old normal maps to the new normal's side.
TEST(Transform, NormalIsUnitAndStaysOnItsSide) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Transform transform = anyTransform(i);
        Random random(2, {i});
        const Vec3 n = inCube(random).normalized();
        const Vec3 normal = transform.normal(n);
        ASSERT_NEAR(normal.norm(), 1, 1e-14) << "Is the result unit?";
        ASSERT_GT(normal.dot(transform.vector(n)), 0) << "Does the determinant's sign matter here?";
    }
}

// A plane in a space of any size and shape: a ray of any length reaches it at the t that world space says.
TEST(Instance, TMeansTheSameInBothSpaces) {
    const Vec3 at(0, 0, 1);
    const auto plane = std::make_shared<Plane>(at, Vec3::UnitZ());
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Transform transform = anyTransform(i);
        const Instance instance(plane, transform);
        Random random(3, {i});
        const Ray local = {3 * inCube(random) + Vec3(0, 0, 10),
                           random.uniform(0.1, 10) * (inCube(random) - Vec3(0, 0, 2))};
        const Ray ray = transform.ray(local);
        const Real t = (1 - local.origin.z()) / local.direction.z();
        const auto hit = instance.intersect(ray);
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit->t, t, 1e-10 * t) << "Was the direction normalised on the way?";
        ASSERT_LE((hit->point - ray.at(t)).norm(), 1e-10 * (ray.at(t).norm() + transform.translation().norm()));
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
    const auto first = std::make_shared<Instance>(plane, Transform(), 0);
    EXPECT_EQ(Instance(first, Transform(), 5).intersect(ray)->object, 0) << "0 is a name like any other.";
}

// A shape whose hit says something in every field, and that remembers the ray it was asked about.
class OneHit final : public Shape {
public:
    OneHit() {
        hit.point = Vec3(0.3, -2, 1);
        hit.ng = Vec3(0.6, 0, 0.8);
        hit.ns = Vec3(0.48, 0.6, 0.64);
        hit.uv = Vec2(0.2, 0.7);
        hit.magnitude = 5;
        hit.t = 1.75;
        hit.dpdu = Vec3(8, 1, -6);
        hit.dpdv = Vec3(-4, 2, 3);
    }
    std::optional<Hit> intersect(const Ray& ray) const override {
        asked = ray;
        if (!ray.reaches(hit.t)) return std::nullopt;
        return hit;
    }
    bool occluded(const Ray& ray) const override { return ray.reaches(hit.t); }
    Bounds3 bounds() const override { return {Vec3::Constant(-5), Vec3::Constant(5)}; }
    std::optional<AreaSample> sampleArea(const Vec2&) const override { return std::nullopt; }
    Real pdfA(const SurfacePoint&) const override { return 0; }

    Hit hit;
    mutable Ray asked;
};

// What the shape says, taken to the world: tangents as vectors, normals as normals, uv and t as they are.
TEST(Instance, EveryFieldOfTheHitIsTheWorlds) {
    const auto shape = std::make_shared<OneHit>();
    const Hit& local = shape->hit;
    for (std::uint64_t i = 0; i < 200; ++i) {
        const Transform transform = anyTransform(i);
        const Instance instance(shape, transform);
        const Ray ray = transform.ray({Vec3(1, 2, 3), Vec3(-1, -2, -3), 1, 4});
        const auto hit = instance.intersect(ray);
        ASSERT_TRUE(hit);
        EXPECT_TRUE(shape->asked.origin.isApprox(Vec3(1, 2, 3), 1e-10)) << "In which space is the shape asked?";
        const Vec3 way = shape->asked.direction.normalized();
        EXPECT_TRUE(way.isApprox(Vec3(-1, -2, -3).normalized(), 1e-10)) << "And the direction?";
        EXPECT_EQ(shape->asked.tMin, 1);
        EXPECT_EQ(shape->asked.tMax, 4);
        EXPECT_TRUE(hit->dpdu.isApprox(transform.vector(local.dpdu), 1e-12)) << "Is dpdu a direction in world space?";
        EXPECT_TRUE(hit->dpdv.isApprox(transform.vector(local.dpdv), 1e-12)) << "And dpdv?";
        EXPECT_TRUE(hit->ns.isApprox(transform.normal(local.ns), 1e-12)) << "Is ns still the shape's own?";
        const SurfacePoint expected = transform.surfacePoint(local);
        EXPECT_TRUE(hit->ng.isApprox(expected.ng, 1e-12));
        EXPECT_TRUE(hit->point.isApprox(expected.point, 1e-12));
        EXPECT_EQ(hit->uv, local.uv);
        EXPECT_NEAR(hit->magnitude, expected.magnitude, 1e-12 * expected.magnitude)
            << "How far must a ray start from the surface, in the world's unit?";
        EXPECT_EQ(hit->t, local.t);
        EXPECT_FALSE(instance.intersect(transform.ray({Vec3(1, 2, 3), Vec3(-1, -2, -3), 2, 4})));
    }
}

}  // namespace
}  // namespace caustic
