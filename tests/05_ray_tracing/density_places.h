#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "math/frame.h"
#include "shape/box.h"
#include "shape/rectangle.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/density_test.h"

/// Every sampler of chapter 05 against the density that it states, by chi-square. Places are named by coordinates of
/// the tests' own, and what a step of them covers (solid angle, area) is measured by finite differences: no formula of
/// the library's is used twice. What spreads light is looked at in property_bsdf.cpp.
namespace caustic::test {

/// π.
inline constexpr Real pi = std::numbers::pi;
/// Of each test.
inline constexpr double falseAlarm = 1e-6;

/// So many samples of all configurations of a sampler together show an error of 3 % in one octant.
inline constexpr int samplesForPower = 1'000'000;

/// Two numbers, the first one first.
inline Vec2 uniformPair(Random& random) {
    const Real x = random.uniform();
    return {x, random.uniform()};
}

/// All configurations hold, and so do they together; a pdf that is wrong by 3 % in the octant that most samples fall
/// into would not.
inline void expectDensities(const std::vector<PlaceSampling>& configurations, const Cells& cells, std::uint64_t seed,
                            int samples = samplesForPower) {
    DensityTest test(cells, samples / static_cast<int>(configurations.size()) + 1, seed);
    for (std::size_t i = 0; i < configurations.size(); ++i)
        EXPECT_GT(test.probability(configurations[i]), falseAlarm) << "configuration " << i;
    EXPECT_GT(test.octantProbability(), falseAlarm);
    EXPECT_LT(test.octantProbability(0.03), falseAlarm) << "the test has lost its power";
    EXPECT_LT(test.octantProbability(-0.03), falseAlarm) << "the test has lost its power";
}

/// Directions around +z or an axis: z over an interval, and the angle. Archimedes: steps of either are areas.
struct DirectionPlaces {
    Frame frame;
    Real zFrom = -1;
    Real zTo = 1;

    /// The coordinates of a direction.
    Place place(const Vec3& direction) const {
        const Vec3 local = frame.toLocal(direction);
        return {(local.z() - zFrom) / (zTo - zFrom), std::atan2(local.y(), local.x()) / (2 * pi) + 0.5, 0, 0};
    }
    /// The direction that they name.
    Vec3 direction(const Place& place) const {
        const Real z = zFrom + place[0] * (zTo - zFrom);
        const Real angle = 2 * pi * (place[1] - 0.5);
        const Real r = std::sqrt(std::max(Real(0), 1 - z * z));
        return frame.toWorld({r * std::cos(angle), r * std::sin(angle), z});
    }
    /// Of all places together, sr.
    Real solidAngle() const { return 2 * pi * std::abs(zTo - zFrom); }
};

/// What a step of the coordinates `a` and `a + 1` of a place covers, when a place is the point `at`.
template <typename At>
inline Vec3 stretch(const At& at, const Place& place, std::size_t a) {
    constexpr Real h = 1e-5;
    const auto derivative = [&](std::size_t axis) -> Vec3 {
        Place before = place;
        Place after = place;
        before[axis] -= h;
        after[axis] += h;
        return (at(after) - at(before)) / (2 * h);
    };
    return derivative(a).cross(derivative(a + 1));
}

/// Surfaces: coordinates a and b (of one of six faces, where there are any), and the point that they name. Where it
/// matters, steps of a and b make a right-handed system with the normal.
struct Surface {
    std::shared_ptr<const Shape> shape;
    std::function<Vec3(const Place&)> point;
    std::function<Place(const Vec3& point, const Vec2& uv)> place;
};

/// A whole sphere, by the directions from its centre.
inline Surface sphere(const Vec3& center, Real radius) {
    const DirectionPlaces places = {{}, 1, -1};
    return {std::make_shared<Sphere>(center, radius),
            [=](const Place& at) -> Vec3 { return center + radius * places.direction(at); },
            [=](const Vec3& point, const Vec2&) { return places.place((point - center) / radius); }};
}

/// A rectangle, by its own uv.
inline Surface rectangle(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV) {
    return {std::make_shared<Rectangle>(corner, edgeU, edgeV),
            [=](const Place& at) -> Vec3 { return corner + at[0] * edgeU + at[1] * edgeV; },
            [](const Vec3&, const Vec2& uv) {
                return Place{uv.x(), uv.y(), 0, 0};
            }};
}

/// How far from a, and how far to c: both are lines through a triangle's corner or along its side.
inline Surface triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {std::make_shared<Triangle>(a, b, c),
            [=](const Place& at) -> Vec3 { return a + at[0] * ((1 - at[1]) * (b - a) + at[1] * (c - a)); },
            [](const Vec3&, const Vec2& uv) {
                return Place{uv.sum(), uv.y() / uv.sum(), 0, 0};
            }};
}

/// A ring cylinder, by the way round its profile and the angle.
inline Surface ring(Real inner, Real outer, Real bottom, Real top) {
    const Real width = outer - inner;
    const Real height = top - bottom;
    const Real around = 2 * (width + height);  // without a hole there is the wall all the same, along the axis
    const auto profile = [=](Real v) -> Vec2 {
        Real way = v * around;
        if (way < width) return {inner + way, bottom};
        way -= width;
        if (way < height) return {outer, bottom + way};
        way -= height;
        if (way < width) return {outer - way, top};
        return {inner, top - (way - width)};
    };
    return {std::make_shared<RingCylinder>(inner, outer, bottom, top),
            [=](const Place& at) -> Vec3 {
                const Vec2 across = profile(at[1]);
                return {across.x() * std::cos(2 * pi * at[0]), across.y(), -across.x() * std::sin(2 * pi * at[0])};
            },
            [](const Vec3&, const Vec2& uv) {
                return Place{uv.x(), uv.y(), 0, 0};
            }};
}

/// The first coordinate is the face, the other two run along it.
inline Surface box(const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low;
    return {std::make_shared<Box>(low, high),
            [=](const Place& at) -> Vec3 {
                const int face = static_cast<int>(at[0] * 6);
                Vec3 share;
                share[face / 2] = face % 2;
                share[(face / 2 + 1) % 3] = at[1];
                share[(face / 2 + 2) % 3] = at[2];
                return low + share.cwiseProduct(size);
            },
            [=](const Vec3& point, const Vec2&) {
                const Vec3 share = (point - low).cwiseQuotient(size);
                int axis = 0;
                const Real nearest = share.cwiseMin(Vec3::Ones() - share).cwiseAbs().minCoeff(&axis);
                EXPECT_LT(nearest, 1e-9);
                const int face = 2 * axis + (share[axis] > 0.5 ? 1 : 0);
                return Place{(face + 0.5) / 6, share[(axis + 1) % 3], share[(axis + 2) % 3], 0};
            }};
}

}  // namespace caustic::test
