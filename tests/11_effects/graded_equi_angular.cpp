#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "medium/equi_angular.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

constexpr int n = 4000;

// Angles, seen from the centre, between the nearest point of the ray and t, and the densities over t.
struct Truth {
    Truth(const Ray& ray, Real end, const Vec3& centre) : tEnd(end) {
        const Real squared = ray.direction.squaredNorm();
        foot = (centre - ray.origin).dot(ray.direction) / squared;
        distance = (centre - ray.at(foot)).norm() / std::sqrt(squared);
    }
    Real angle(Real t) const { return std::atan((t - foot) / distance); }
    Real share(Real t) const { return (angle(t) - angle(0)) / (angle(tEnd) - angle(0)); }
    Real pdf(Real t) const {
        return distance / ((angle(tEnd) - angle(0)) * (distance * distance + (t - foot) * (t - foot)));
    }

    Real tEnd;
    Real foot = 0;
    Real distance = 0;
};

// Places of n numbers in equal steps: their shares of the angle are in such steps, too, in whatever order.
void expectEvenAngles(const Ray& ray, Real tEnd, const Vec3& centre) {
    const Truth truth(ray, tEnd, centre);
    std::vector<Real> shares;
    for (int i = 0; i < n; ++i) {
        const PlaceOnRay place = sampleEquiAngular(ray, tEnd, centre, (i + 0.5) / n);
        ASSERT_GE(place.t, 0);
        ASSERT_LE(place.t, tEnd) << "The ray ends there.";
        ASSERT_NEAR(place.pdf / truth.pdf(place.t), 1, 1e-9) << "Density over t: D / (Δθ (D² + (t − foot)²))?";
        shares.push_back(truth.share(place.t));
    }
    std::sort(shares.begin(), shares.end());
    for (int i = 0; i < n; ++i)
        ASSERT_NEAR(shares[static_cast<std::size_t>(i)], (i + 0.5) / n, 1e-9) << "Evenly spread angles?";
}

// However near the number is to 1, the place is on the ray.
void expectWithinTheRay(const Ray& ray, Real tEnd, const Vec3& centre) {
    for (const Real u : {0.0, 1e-300, 1 - 0x1p-30, 1 - 0x1p-53}) {
        const PlaceOnRay place = sampleEquiAngular(ray, tEnd, centre, u);
        ASSERT_TRUE(place.t >= 0 && place.t <= tEnd) << "u = " << u << ": the ray ends at " << tEnd;
    }
}

// Rays from anywhere past anything, at scales from a millimetre to a kilometre; the centre before, beside and behind.
TEST(EquiAngular, SpreadsAnglesEvenly) {
    Random random(3, {});
    for (int i = 0; i < 60; ++i) {
        const Real scale = std::pow(10, random.uniform(-3, 3));
        const Ray ray = {scale * test::inCube(random), test::inCube(random).normalized()};
        const Vec3 centre = ray.origin + scale * test::inCube(random);
        expectEvenAngles(ray, scale * random.uniform(0.1, 3), centre);
    }
    for (int i = 0; i < 20'000; ++i) {
        const Real scale = std::pow(10, random.uniform(-3, 3));
        const Ray ray = {scale * test::inCube(random), test::inCube(random).normalized()};
        expectWithinTheRay(ray, scale * random.uniform(0.1, 3), ray.origin + scale * test::inCube(random));
    }
}

// t counts in lengths of the direction, and so does the density.
TEST(EquiAngular, CountsInLengthsOfTheDirection) {
    for (const Real length : {1e-2, 0.3, 20.0}) {
        const Ray ray = {Vec3(0.4, -1, 0.2), length * Vec3(0.6, 0.64, 0.48)};
        expectEvenAngles(ray, 2 / length, Vec3(1.2, -0.3, 0.9));
    }
}

// A ray without an end: the angles go to π/2.
TEST(EquiAngular, ReachesToInfinity) {
    for (const Vec3& centre : {Vec3(0.5, 0.2, -0.1), Vec3(3, 1, 2)})
        expectEvenAngles({Vec3(-0.3, 0.5, 0.2), Vec3(0.6, 0, 0.8)}, std::numeric_limits<Real>::infinity(), centre);
}

// A lamp on the ray, before it, in the midst of it and beyond it, at both ends: no angles to spread, and yet each place
// has a density. Before and beyond the piece its integral is 1 in plain numbers: the mean of 1/pdf is the length.
TEST(EquiAngular, BearsACentreOnTheRay) {
    constexpr int samples = 20'000;
    const Ray ray = {Vec3(0.3, -2, 1), Vec3(0.6, 0, 0.8)};
    for (const Real at : {-2.0, 0.0, 0.7, 1.5, 4.0}) {
        Real sum = 0;
        for (int i = 0; i < samples; ++i) {
            const PlaceOnRay place = sampleEquiAngular(ray, 1.5, ray.at(at), (i + 0.5) / samples);
            ASSERT_TRUE(std::isfinite(place.t) && place.t >= 0 && place.t <= 1.5) << "lamp at t = " << at;
            ASSERT_TRUE(std::isfinite(place.pdf) && place.pdf > 0) << "lamp at t = " << at;
            sum += 1 / place.pdf / samples;
        }
        if (at < 0 || at > 1.5) {
            EXPECT_NEAR(sum, 1.5, 1e-3) << "lamp at t = " << at;
        }
    }
}

}  // namespace
}  // namespace caustic
