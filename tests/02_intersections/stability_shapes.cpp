#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "core/error.h"
#include "leaving.h"
#include "math/transform.h"
#include "measures/sphere_accuracy.h"
#include "shape/ball.h"
#include "shape/box.h"
#include "shape/group.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"

namespace caustic {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

TEST(BadInput, SizesMustBePositiveAndFinite) {
    for (const Real bad : {0.0, -1.0, nan, infinity}) {
        EXPECT_THROW(Sphere(Vec3::Zero(), bad), InputError) << bad;
        EXPECT_THROW(RingCylinder(0, bad, 0, 1), InputError) << bad;
        EXPECT_THROW(RingCylinder(0.5, 0.5 + bad, 0, 1), InputError) << bad;
        EXPECT_THROW(RingCylinder(0, 1, 2, 2 + bad), InputError) << bad;
        EXPECT_THROW(Box(Vec3::Zero(), Vec3(1, bad, 1)), InputError) << bad;
        EXPECT_THROW(Transform::scaling(Vec3(1, bad < 0 ? 0 : bad, 1)), InputError) << bad;
    }
    EXPECT_THROW(RingCylinder(-0.1, 1, 0, 1), InputError);
    EXPECT_THROW(RingCylinder(nan, 1, 0, 1), InputError);
}

TEST(BadInput, CoordinatesMustBeFinite) {
    for (const Real bad : {nan, infinity, -infinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 p = bad * Vec3::Unit(axis).cwiseMax(0.1);
            EXPECT_THROW(Sphere(p, 1), InputError);
            EXPECT_THROW(Box(p, Vec3::Ones()), InputError);
            EXPECT_THROW(Plane(p, Vec3::UnitX()), InputError);
            EXPECT_THROW(Plane(Vec3::Zero(), p), InputError);
            EXPECT_THROW(Triangle(p, Vec3::UnitX(), Vec3::UnitY()), InputError);
            EXPECT_THROW(Triangle(Vec3::Zero(), Vec3::UnitX(), p), InputError);
            EXPECT_THROW(Transform::translation(p), InputError);
        }
        EXPECT_THROW(RingCylinder(0, 1, bad, 1), InputError);
        EXPECT_THROW(Transform::rotation(Vec3::UnitX(), bad), InputError);
    }
}

TEST(BadInput, DegenerateThingsAreRefused) {
    EXPECT_THROW(Triangle(Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()), InputError) << "no area";
    EXPECT_THROW(Triangle(Vec3::Ones(), Vec3::Ones(), Vec3::Ones()), InputError);
    EXPECT_THROW(Plane(Vec3::Zero(), Vec3::Zero()), InputError) << "no normal";
    EXPECT_THROW(Transform::rotation(Vec3::Zero(), 1), InputError) << "no axis";
    EXPECT_THROW(Group({}), InputError);
    EXPECT_THROW(Group({nullptr}), InputError);
    EXPECT_THROW(Instance(nullptr, Transform()), InputError);
}

TEST(BadInput, MessageNamesTheValueAndTheReason) {
    try {
        const Sphere sphere(Vec3::Zero(), -2);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "sphere's radius: must be greater than 0 (got '-2')");
    }
}

// Flattened exactly, and flattened by maps that hide it behind rounding.
TEST(SingularTransform, IsAnInputError) {
    Mat3 flat = Mat3::Identity();
    flat(2, 2) = 0;
    EXPECT_THROW(Transform(flat, Vec3::Zero()), InputError);
    EXPECT_THROW(Transform(Mat3::Zero(), Vec3::Zero()), InputError);
    EXPECT_THROW(Transform(Mat3::Ones(), Vec3::Zero()), InputError);
    EXPECT_THROW(Transform(Mat3::Constant(nan), Vec3::Zero()), InputError);
    for (int i = 0; i < 1000; ++i) {
        Random random(1, {static_cast<std::uint64_t>(i)});
        const Mat3 turn = Transform::rotation(randomDirection(random), random.uniform(0, 6)).linear();
        const Mat3 back = Transform::rotation(randomDirection(random), random.uniform(0, 6)).linear();
        EXPECT_THROW(Transform(turn * flat * back, Vec3::Zero()), InputError) << turn;
    }
}

TEST(SingularTransform, TinyAndHugeScalesAreNotSingular) {
    for (const Real scale : {1e-100, 1e-12, 1e12, 1e100}) {
        const Transform transform = Transform::scaling({scale, -2 * scale, 1});
        EXPECT_LE((transform.inverse().point(transform.point({1, 2, 3})) - Vec3(1, 2, 3)).norm(), 1e-14);
    }
    EXPECT_THROW(Transform::scaling({1e-320, 1, 1}), InputError) << "Its inverse overflows.";
}

// A ray within the surface of a solid is in the solid, like any point of the closed set.
TEST(RaysWithinSurfaces, BoxAndCylinderTreatThemAsInside) {
    const Box box(Vec3::Zero(), Vec3::Ones());
    for (const Real y : {0.0, 1.0}) {
        EXPECT_TRUE(box.occluded({Vec3(-1, y, 0.5), Vec3(1, 0, 0)})) << "in a face";
        EXPECT_TRUE(box.occluded({Vec3(-1, y, 0), Vec3(1, 0, -0.0)})) << "along an edge";
        EXPECT_TRUE(box.occluded({Vec3(-1, y, 1), Vec3(1, -0.0, 0)})) << "along an edge";
    }
    const RingCylinder cylinder(0, 1, 0, 1);
    EXPECT_TRUE(cylinder.occluded({Vec3(1, -1, 0), Vec3(0, 1, 0)})) << "along the wall";
    EXPECT_TRUE(cylinder.occluded({Vec3(-3, 1, 0), Vec3(1, 0, 0)})) << "in the top";
    EXPECT_FALSE(cylinder.occluded({Vec3(1.0000001, -1, 0), Vec3(0, 1, 0)}));
}

TEST(RingCylinderStability, RaysAlongTheAxisGoThroughTheHole) {
    const RingCylinder ring(0.5, 1, -1, 1);
    for (const Real x : {0.0, -0.0, 0.3, 0.49999}) {
        EXPECT_FALSE(ring.occluded({Vec3(x, -5, 0), Vec3(0, 1, 0)})) << x;
        EXPECT_FALSE(ring.occluded({Vec3(x, -5, 0), Vec3(1e-12, 1, -0.0)})) << x;
    }
    for (const Real x : {0.50001, 0.7, 0.99999}) {
        const auto hit = ring.intersect({Vec3(x, -5, 0), Vec3(0, 1, 0)});
        ASSERT_TRUE(hit) << x;
        EXPECT_EQ(hit->point, Vec3(x, -1, 0));
        EXPECT_EQ(hit->ng, Vec3(0, -1, 0));
    }
}

TEST(PlaneStability, ParallelRaysMissEvenFromWithin) {
    const Plane plane(Vec3(0, 1, 0), Vec3::UnitY());
    EXPECT_FALSE(plane.occluded({Vec3(0, 1, 0), Vec3(1, 0, 2)}));
    EXPECT_FALSE(plane.occluded({Vec3(0, 2, 0), Vec3(1, 0, 2)}));
    EXPECT_FALSE(plane.occluded({Vec3(0, 2, 0), Vec3(1, -0.0, 2)}));
}

// The poles: u has no meaning there, everything else has.
TEST(SphereStability, PolesAreFinite) {
    const Sphere sphere(Vec3(1, 2, 3), 0.5);
    for (const Real side : {1.0, -1.0}) {
        const auto hit = sphere.intersect({Vec3(1, 2 + 5 * side, 3), Vec3(0, -side, 0)});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->ng, Vec3(0, side, 0));
        EXPECT_TRUE(hit->uv.allFinite() && hit->dpdu.allFinite() && hit->dpdv.allFinite());
        EXPECT_EQ(hit->uv.y(), side > 0 ? 1 : 0);
        EXPECT_GT(hit->dpdv.norm(), 1);
    }
}

// 10⁷ radii away the projection still knows to a millionth of the radius where the ray enters; Pythagoras lost it.
TEST(SphereStability, FarSpheresKeepTheirDigits) {
    int pythagorasWrong = 0;
    for (int i = 0; i < 2000; ++i) {
        Random random(2, {static_cast<std::uint64_t>(i)});
        const Vec3 d = randomDirection(random);
        const Real aside = random.uniform(0, 0.99);
        const Vec3 toCenter = 1e7 * d + aside * d.unitOrthogonal();
        const Interval inside = ballInterval<Real, 3>(toCenter, d, 1.0);
        ASSERT_FALSE(inside.empty());
        // The direction is rounded to 1e-16, which 10⁷ radii make 1e-9 of a radius beside the centre.
        EXPECT_NEAR((inside.upper - inside.lower) / 2, std::sqrt(1 - aside * aside), 1e-6);
        const Interval lost = pythagorasProjection<Real>(toCenter, d, 1.0);
        if (lost.empty() || std::abs((lost.upper - lost.lower) / 2 - std::sqrt(1 - aside * aside)) > 1e-3)
            ++pythagorasWrong;
    }
    EXPECT_GT(pythagorasWrong, 500);
}

// What the chart's rays are, they are as rounded numbers: a ray that rounding moved past the sphere has no t to
// compare.
template <typename Scalar>
void expectTrueHits(double distance) {
    for (const auto& [toCenter, direction] : sphereCases<Scalar>(distance, 200, 3)) {
        const Real113 t = nearerRoot113<Scalar>(toCenter, direction, Scalar(1));
        EXPECT_NEAR(static_cast<double>(t), distance, 1 + 1e-6 * distance) << "NaN for a miss";
    }
}

TEST(SphereStability, ChartedRaysHitAtEveryDistance) {
    for (int exponent = 0; exponent <= 7; ++exponent) {
        expectTrueHits<float>(std::pow(10, exponent));
        expectTrueHits<double>(std::pow(10, exponent));
    }
}

}  // namespace
}  // namespace caustic
