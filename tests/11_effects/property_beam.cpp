#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/point_beam_tree.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/photon_volume.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using Places = std::vector<std::uint32_t>;

Places found(const PointBeamTree& tree, const Beam& beam) {
    Places places;
    tree.along(beam, [&](const BeamPoint& near) {
        EXPECT_TRUE(beam.holds(near));
        EXPECT_NEAR(near.squaredDistance, (tree.point(near.place) - beam.ray.at(near.t)).squaredNorm(),
                    1e-9 * beam.radius * beam.radius);
        places.push_back(tree.order()[near.place]);
    });
    std::sort(places.begin(), places.end());
    return places;
}

Places bruteForce(const std::vector<Vec3>& points, const Beam& beam) {
    Places places;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (beam.holds(beam.nearest(i, points[i]))) places.push_back(i);
    }
    return places;
}

Ray towards(const Vec3& from, const Vec3& to, Real tMax = std::numeric_limits<Real>::infinity()) {
    return {from, (to - from).normalized(), 0, tMax};
}

// From one point to tens of thousands, about and at the sizes at which a level is added; scales from 1e-3 to 1e3; rays
// from within, from outside, from far away, that end midway, along axes.
TEST(BeamTree, FindsWhatBruteForceFinds) {
    Random random(1, {});
    std::int64_t all = 0;
    for (const std::size_t count : {1, 2, 16, 17, 128, 129, 1000, 1024, 1025, 20'000}) {
        for (const Real scale : {1e-3, 1.0, 1e3}) {
            const Vec3 offset = 5 * scale * test::inCube(random);
            std::vector<Vec3> points;
            for (std::size_t i = 0; i < count; ++i)
                points.push_back(offset + scale * test::inCube(random).cwiseProduct(Vec3(1, 0.3, 0.05)));
            const PointBeamTree tree(points);
            ASSERT_EQ(tree.size(), count);
            for (int i = 0; i < 30; ++i) {
                const Real far = i % 3 == 0 ? 0.5 : i % 3 == 1 ? 3 : 1e4;
                const Vec3 from = offset + far * scale * test::inCube(random);
                const Vec3 to = offset + 0.5 * scale * test::inCube(random).cwiseProduct(Vec3(1, 0.3, 0.05));
                const Real tMax = i % 2 == 0 ? std::numeric_limits<Real>::infinity() : (to - from).norm();
                for (const Real radius : {0.01 * scale, 0.2 * scale}) {
                    const Beam beam = {towards(from, to, tMax), radius};
                    const Places expected = bruteForce(points, beam);
                    ASSERT_EQ(found(tree, beam), expected) << count << " points, scale " << scale << ", ray " << i;
                    all += static_cast<std::int64_t>(expected.size());
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                const Beam beam = {{points[count / 2] - 2 * scale * Vec3::Unit(axis), Vec3::Unit(axis)}, 0.05 * scale};
                ASSERT_EQ(found(tree, beam), bruteForce(points, beam));
            }
        }
    }
    EXPECT_GT(all, 100'000);
}

// All points at one place, on a line and in a plane that the ray runs in; none; a radius of 0; a direction of any
// length.
TEST(BeamTree, BearsPointsOnTopOfEachOther) {
    Random random(2, {});
    for (const int spread : {0, 1, 2}) {
        std::vector<Vec3> points;
        for (int i = 0; i < 3000; ++i) {
            Vec3 point(0.25, 0.5, -0.125);
            for (int axis = 0; axis < spread; ++axis) point[axis] = std::round(8 * random.uniform()) / 8;
            points.push_back(point);
        }
        const PointBeamTree tree(points);
        for (const Real length : {1.0, 0.01, 300.0}) {
            for (const Real radius : {0.0, 0.125, 0.3}) {
                const Beam beam = {{Vec3(-1, 0.5, -0.125), length * Vec3::UnitX()}, radius};
                EXPECT_EQ(found(tree, beam), bruteForce(points, beam)) << spread << ", " << length << ", " << radius;
            }
        }
    }
    EXPECT_EQ(found(PointBeamTree({}), {{Vec3::Zero(), Vec3::UnitX()}, 1}).size(), 0U);
}

TEST(BeamTree, RefusesPointsThatAreNowhere) {
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(), 1e160}) {
        const std::vector<Vec3> points = {Vec3::Zero(), Vec3(0, bad, 0)};
        EXPECT_THROW(PointBeamTree{points}, InputError);
    }
}

// A million photons: the same sum as brute force, to 1e-9; and on the way only few of them are looked at.
TEST(BeamTree, GathersAMillionPhotonsAsBruteForceDoes) {
    Random random(3, {});
    std::vector<Photon> photons(1'000'000);
    for (Photon& photon : photons) {
        photon.point = test::inCube(random);
        photon.wi = test::inCube(random).normalized();
        photon.power = {random.uniform(), random.uniform(), random.uniform()};
        photon.length = 2;
        photon.way = PhotonWay::Indirect;
    }
    const PhotonVolume volume(photons);
    const Color sigmaT(0.5, 1, 2);
    const HenyeyGreenstein phase(-0.3);
    const HomogeneousMedium medium(0.3 * sigmaT, 0.7 * sigmaT, std::make_shared<HenyeyGreenstein>(phase));
    for (int i = 0; i < 6; ++i) {
        const Ray ray = towards(3 * test::inCube(random), 0.3 * test::inCube(random));
        const MediumSpan span = {ray, 4.5, &medium, {}, Color::Ones()};
        const Real radius = 0.02;
        const Beam beam = {{ray.origin, ray.direction, 0, span.tEnd}, radius};
        Color expected = Color::Zero();
        for (const Photon& photon : photons) {
            const BeamPoint near = beam.nearest(0, photon.point);
            if (beam.holds(near))
                expected += photon.power * (-sigmaT * near.t).exp() * phase.p(-ray.direction, photon.wi) *
                            beamKernel(near.squaredDistance, radius);
        }
        EXPECT_LE((volume.radiance(span, {radius, 9, 1, true}) - expected).abs().maxCoeff(),
                  1e-9 * expected.maxCoeff());
    }
}

// The kernel spreads all of a photon over its disc, and nothing beyond.
TEST(BeamKernel, SumsToOne) {
    for (const Real radius : {1e-3, 1.0, 50.0}) {
        constexpr int n = 10'000;
        Real sum = 0;
        for (int i = 0; i < n; ++i) {
            const Real d = (i + 0.5) / n * radius;
            sum += 2 * 3.14159265358979323846 * d * radius / n * beamKernel(d * d, radius);
        }
        EXPECT_NEAR(sum, 1, 1e-7);
        EXPECT_EQ(beamKernel(radius * radius, radius), 0);
    }
}

}  // namespace
}  // namespace caustic
