#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "density_places.h"
#include "light/cone_light.h"
#include "sampling/warp.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/rectangle.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/density_test.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

using namespace test;

// Warps.

PlaceSampling warped(const DirectionPlaces& places, Vec3 (*warp)(const Vec2&, Real), Real argument,
                     Real (*density)(Real z, Real argument)) {
    return {[=](Random& random) { return places.place(warp(uniformPair(random), argument)); },
            [=](const Place& at) { return density(places.direction(at).z(), argument) * places.solidAngle(); }};
}

TEST(Densities, UniformSphere) {
    expectDensities(
        {warped(
            {}, [](const Vec2& u, Real) { return uniformSphere(u); }, 0, [](Real, Real) { return 1 / (4 * pi); })},
        test::planeCells, 1);
}

TEST(Densities, CosineHemisphere) {
    expectDensities({warped(
                        {{}, 0, 1}, [](const Vec2& u, Real) { return cosineHemisphere(u); }, 0,
                        [](Real z, Real) { return z / pi; })},
                    test::planeCells, 2);
}

TEST(Densities, UniformCone) {
    std::vector<PlaceSampling> cones;
    for (const Real cosLimit : {-1.0, -0.7, -0.2, 0.0, 0.3, 0.6, 0.9, 0.99, 0.9999})
        cones.push_back(
            warped({{}, cosLimit, 1}, uniformCone, cosLimit, [](Real, Real c) { return 1 / (2 * pi * (1 - c)); }));
    expectDensities(cones, test::planeCells, 3);
}

TEST(Densities, PowerHemisphere) {
    std::vector<PlaceSampling> powers;
    // From where all but e^-40 of the lobe is on, so that cells are as fine as it is.
    for (const Real exponent : {0.0, 0.5, 1.0, 2.0, 6.0, 20.0, 100.0, 500.0, 10'000.0})
        powers.push_back(warped({{}, std::exp(-40 / (exponent + 1)) < 0.5 ? 0 : std::exp(-40 / (exponent + 1)), 1},
                                powerHemisphere, exponent,
                                [](Real z, Real n) { return (n + 1) / (2 * pi) * std::pow(z, n); }));
    expectDensities(powers, test::planeCells, 4);
}

TEST(Densities, ConcentricDisc) {
    const PlaceSampling disc = {[](Random& random) {
                                    const Vec2 p = concentricDisc(uniformPair(random));
                                    return Place{p.squaredNorm(), std::atan2(p.y(), p.x()) / (2 * pi) + 0.5, 0, 0};
                                },
                                [](const Place&) { return 1; }};
    expectDensities({disc}, test::planeCells, 5);
}

std::vector<Transform> someTransforms() {
    Mat3 sheared;
    sheared << 1, 0.4, -0.3, 0, 0.7, 0.5, 0.2, 0, 1.9;
    return {Transform(),
            Transform::rotation({1, 2, 3}, 0.8),
            Transform::scaling({2.5, 2.5, 2.5}),
            Transform::scaling({0.3, 2, 1}),
            Transform::scaling({1, -1, 4}),
            Transform(sheared, {3, -2, 1})};
}

// The sampler of a surface, in its place and moved, stretched, mirrored and sheared.
std::vector<PlaceSampling> areaSamplers(const Surface& surface, std::size_t along = 0) {
    std::vector<PlaceSampling> samplings;
    for (const Transform& toWorld : someTransforms()) {
        const auto instance = std::make_shared<Instance>(surface.shape, toWorld);
        const Transform toLocal = toWorld.inverse();
        samplings.push_back({[=](Random& random) {
                                 const auto sample = instance->sampleArea(uniformPair(random));
                                 return surface.place(toLocal.point(sample->at.point), sample->at.uv);
                             },
                             [=](const Place& place) {
                                 const auto world = [&](const Place& at) { return toWorld.point(surface.point(at)); };
                                 const Vec3 area = stretch(world, place, along);
                                 if (area.isZero(0)) return Real(0);
                                 SurfacePoint at;
                                 at.point = world(place);
                                 at.ng = area.normalized();
                                 return instance->pdfA(at) * area.norm() * (along > 0 ? 6 : 1);
                             }});
    }
    return samplings;
}

template <typename... More>
std::vector<PlaceSampling> together(std::vector<PlaceSampling> all, const More&... more) {
    (all.insert(all.end(), more.begin(), more.end()), ...);
    return all;
}

TEST(Densities, AreaOfSpheres) {
    expectDensities(together(areaSamplers(sphere({0, 0, 0}, 1)), areaSamplers(sphere({1, -2, 3}, 0.2))),
                    test::planeCells, 6);
}

TEST(Densities, AreaOfRectangles) {
    expectDensities(together(areaSamplers(rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
                             areaSamplers(rectangle({1, 2, 3}, {0.1, 0.2, 0}, {-4, 2, 3}))),
                    test::planeCells, 7);
}

TEST(Densities, AreaOfTriangles) {
    expectDensities(together(areaSamplers(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
                             areaSamplers(triangle({1, 0, 2}, {4, 1, 2.5}, {-1, 0.2, 2}))),
                    test::planeCells, 8);
}

TEST(Densities, AreaOfRingCylinders) {
    expectDensities(together(areaSamplers(ring(0, 1, 0, 2)), areaSamplers(ring(0.5, 1, -1, 0.5)),
                             areaSamplers(ring(0.9, 1, -0.02, 0.02))),
                    test::planeCells, 9);
}

TEST(Densities, AreaOfBoxes) {
    expectDensities(together(areaSamplers(box({0, 0, 0}, {1, 1, 1}), 1), areaSamplers(box({-1, 2, 0}, {2, 2.1, 7}), 1)),
                    test::faceCells, 10);
}

// The kit itself: a density that is too large everywhere is wrong, and so is one that forgets what fails.
TEST(Densities, ClaimsMustAddUp) {
    const PlaceSampling tooLarge = {[](Random& random) {
                                        const Vec2 u = uniformPair(random);
                                        return Place{u.x(), u.y(), 0, 0};
                                    },
                                    [](const Place&) { return 1.001; }};
    EXPECT_EQ(DensityTest(test::planeCells, 1000, 20).probability(tooLarge), 0);
    const PlaceSampling failing = {[](Random& random) -> std::optional<Place> {
                                       const Vec2 u = uniformPair(random);
                                       if (u.x() < 0.1) return std::nullopt;
                                       return Place{u.x(), u.y(), 0, 0};
                                   },
                                   [](const Place&) { return 1; }};
    EXPECT_EQ(DensityTest(test::planeCells, 10'000, 21).probability(failing), 0);
}

}  // namespace
}  // namespace caustic
