#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "leaving.h"
#include "math/frame.h"
#include "math/slabs.h"
#include "shape_catalogue.h"

namespace caustic {
namespace {

TEST(Transform, InverseUndoesEverything) {
    for (const bool mirrored : {false, true}) {
        const Transform transform = Transform::translation({3, -1, 2}) * unevenTransform(mirrored);
        const Transform back = transform.inverse();
        for (int i = 0; i < 1000; ++i) {
            Random random(1, {static_cast<std::uint64_t>(i)});
            const Vec3 p = 5 * randomInBall(random);
            const Vec3 n = randomDirection(random);
            EXPECT_LE((back.point(transform.point(p)) - p).norm(), 1e-13);
            EXPECT_LE((back.vector(transform.vector(p)) - p).norm(), 1e-13);
            EXPECT_LE((back.normal(transform.normal(n)) - n).norm(), 1e-13);
        }
    }
}

TEST(Transform, ProductAppliesTheRightOneFirst) {
    const Transform turn = Transform::rotation(Vec3::UnitZ(), std::numbers::pi / 2);
    const Transform move = Transform::translation({1, 0, 0});
    EXPECT_LE(((turn * move).point(Vec3::Zero()) - Vec3(0, 1, 0)).norm(), 1e-15);
    EXPECT_LE(((move * turn).point(Vec3::UnitX()) - Vec3(1, 1, 0)).norm(), 1e-15);
}

// Area of the image of a parallelogram: the length of the cross product of its transformed sides.
TEST(Transform, AreaScaleIsWhatParallelogramsGrowBy) {
    const Transform transform = unevenTransform(true);
    for (int i = 0; i < 1000; ++i) {
        Random random(2, {static_cast<std::uint64_t>(i)});
        const Frame frame = Frame::around(randomDirection(random));
        const Real area = transform.vector(frame.s).cross(transform.vector(frame.t)).norm();
        EXPECT_NEAR(transform.areaScale(frame.n), area, 1e-12 * area);
    }
}

TEST(Transform, BoundsContainTheImageAndFitTightly) {
    const Bounds3 box(Vec3(-1, 2, 0.5), Vec3(3, 2.5, 4));
    for (const bool mirrored : {false, true}) {
        const Transform transform = Transform::translation({1, 2, 3}) * unevenTransform(mirrored);
        Bounds3 corners;
        for (int corner = 0; corner < 8; ++corner) {
            corners.extend(transform.point(box.corner(static_cast<Bounds3::CornerType>(corner))));
        }
        const Bounds3 bounds = transform.bounds(box);
        EXPECT_TRUE(bounds.contains(corners));
        EXPECT_LE((bounds.sizes() - corners.sizes()).norm(), 1e-13);
    }
    EXPECT_TRUE(unevenTransform(false).bounds(Bounds3()).isEmpty());
}

// Duff et al. give their basis for every unit vector, the pole that Frisvad's older one loses too.
TEST(Frame, IsOrthonormalAroundEveryNormal) {
    const auto check = [](const Vec3& n) {
        const Frame frame = Frame::around(n);
        Mat3 axes;
        axes << frame.s, frame.t, frame.n;
        EXPECT_LE((axes.transpose() * axes - Mat3::Identity()).norm(), 1e-14) << n.transpose();
        EXPECT_NEAR(axes.determinant(), 1, 1e-14) << "Is it right-handed?";
        const Vec3 v(0.3, -2, 5);
        EXPECT_LE((frame.toWorld(frame.toLocal(v)) - v).norm(), 1e-14);
    };
    for (int axis = 0; axis < 3; ++axis) {
        check(Vec3::Unit(axis));
        check(-Vec3::Unit(axis));
    }
    for (int i = 0; i < 10000; ++i) {
        Random random(3, {static_cast<std::uint64_t>(i)});
        check(randomDirection(random));
        check(Vec3(1e-9 * random.uniform(-1, 1), 1e-9 * random.uniform(-1, 1), -1).normalized());
    }
}

}  // namespace
}  // namespace caustic
