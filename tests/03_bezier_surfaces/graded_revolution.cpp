#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"
#include "support/in_cube.h"
#include "surface/revolved_segment.h"
#include "surface/surface_of_revolution.h"

namespace caustic {
namespace {

using test::inCube;

constexpr Real pi = std::numbers::pi;

BezierCurve cubic() { return BezierCurve({Vec3(0.6, -1, 0), Vec3(1.5, -0.4, 0), Vec3(-0.2, 0.3, 0), Vec3(0.8, 1, 0)}); }

Ray randomRay(std::uint64_t i) {
    Random random(7, {i});
    const Vec3 from = 2 * inCube(random);
    return {from, inCube(random) - from};
}

// Turned by a quarter, the profile's point (x, y) lies at z = x; the circle through it has the length 2 π x.
TEST(SurfaceOfRevolution, PointsAreTheProfileTurned) {
    const SurfaceOfRevolution surface({cubic()});
    const Vec3 p = cubic().position(0.3);
    EXPECT_LE((surface.evaluate(0.3, 0).point - Vec3(p.x(), p.y(), 0)).norm(), 1e-14);
    EXPECT_LE((surface.evaluate(0.3, 0.25).point - Vec3(0, p.y(), p.x())).norm(), 1e-14)
        << "Is v counted in turns, from x towards z?";
}

// Central differences of the surface's points; two segments, so that u runs twice as fast along each.
TEST(SurfaceOfRevolution, DerivativesMatchDifferences) {
    const auto [lower, upper] = cubic().split(0.4);
    const SurfaceOfRevolution surface({lower, upper});
    constexpr Real h = 1e-5;
    for (const Real u : {0.2, 0.7}) {
        for (const Real v : {0.1, 0.6}) {
            const SurfaceJet jet = surface.evaluate(u, v);
            const Vec3 du = (surface.evaluate(u + h, v).point - surface.evaluate(u - h, v).point) / (2 * h);
            const Vec3 dv = (surface.evaluate(u, v + h).point - surface.evaluate(u, v - h).point) / (2 * h);
            EXPECT_LE((jet.du - du).norm(), 1e-7) << "Does u run over all segments from 0 to 1?";
            EXPECT_LE((jet.dv - dv).norm(), 1e-7) << "How long is the circle that v runs through once?";
        }
    }
}

// f from its definition, for random lines: rise² (near² - x²) + 2 drift rise h + flat² h².
Real byDefinition(const AxisRay& ray, const Vec3& p) {
    const Real h = p.y() - ray.baseHeight;
    return ray.rise * ray.rise * (ray.near * ray.near - p.x() * p.x()) + 2 * ray.drift * ray.rise * h +
           ray.flatSquare * h * h;
}

Real bernsteinValue(const RevolvedSegment::Equation& f, Real u) {
    std::vector<Real> c(f.coefficient.begin(), f.coefficient.begin() + f.degree + 1);
    for (std::size_t left = c.size(); left > 1; --left) {
        for (std::size_t i = 0; i + 1 < left; ++i) c[i] = (1 - u) * c[i] + u * c[i + 1];
    }
    return c[0];
}

TEST(RevolvedSegment, EquationIsTheLinesDistanceAgainstTheProfiles) {
    const RevolvedSegment segment(cubic());
    for (std::uint64_t i = 0; i < 200; ++i) {
        const AxisRay ray(randomRay(i), 0.1);
        const RevolvedSegment::Equation f = segment.equation(ray);
        ASSERT_EQ(f.degree, 6);
        for (const Real u : {0.0, 0.3, 0.8, 1.0}) {
            EXPECT_NEAR(bernsteinValue(f, u), byDefinition(ray, cubic().position(u)), 1e-13)
                << "Are the segment's heights counted from its middle, and the line's from its base?";
        }
    }
}

// Two segments that share an end have the same value there, each to within its bound; and the bound must not be a
// hundred times what is needed for moderate numbers.
TEST(RevolvedSegment, EquationsErrorIsBoundedAndSmall) {
    const auto [below, above] = cubic().split(0.4);
    const RevolvedSegment lower(below);
    const RevolvedSegment upper(above);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const AxisRay ray(randomRay(i), 0.1);
        const RevolvedSegment::Equation f = lower.equation(ray);
        const RevolvedSegment::Equation g = upper.equation(ray);
        EXPECT_LE(std::abs(f.coefficient[6] - g.coefficient[0]), f.error + g.error)
            << "Which terms can be larger than their sum?";
        EXPECT_GT(f.error, 0);
        EXPECT_LE(f.error, 2e-13) << "Does the bound grow with the terms, or is it a guess?";
    }
}

// All meetings by walking along the line in small steps: a change of side of the surface is a meeting.
int meetingsByWalking(const Ray& ray, const RevolvedSegment& segment, int& found) {
    found = segment.roots(AxisRay(ray, 0)).count;
    constexpr int steps = 20000;
    int changes = 0;
    Real before = 0;
    for (int i = 0; i <= steps; ++i) {
        const Vec3 p = cubic().position(Real(i) / steps);
        const Real value = byDefinition(AxisRay(ray, 0), p);
        if (i > 0 && (value < 0) != (before < 0)) ++changes;
        before = value;
    }
    return changes;
}

TEST(RevolvedSegment, FindsEveryRoot) {
    const RevolvedSegment segment(cubic());
    int several = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        int found = 0;
        const int expected = meetingsByWalking(randomRay(i), segment, found);
        EXPECT_EQ(found, expected) << "Ray " << i << ": are both halves searched?";
        several += expected > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 50) << "Many of these rays meet the surface more than once.";
}

TEST(RevolvedSegment, RootsAreWhereLineAndSurfaceMeet) {
    const RevolvedSegment segment(cubic());
    for (std::uint64_t i = 0; i < 300; ++i) {
        const Ray ray = randomRay(i);
        const AxisRay axisRay(ray, 0);
        for (const RevolvedRoot& root : segment.roots(axisRay)) {
            const Vec3 onLine = ray.at(axisRay.tAt(root.distance));
            const Vec3 onProfile = cubic().position(root.u);
            EXPECT_NEAR(std::hypot(onLine.x(), onLine.z()), std::abs(onProfile.x()), 1e-12)
                << "Ray " << i << ": is the root's u that of the whole segment, or of a half?";
            EXPECT_NEAR(onLine.y(), onProfile.y(), 1e-12);
        }
    }
}

// In a plane of rotation the equation is a square, and has no change of sign; two meetings there are all the same.
TEST(RevolvedSegment, RaysNearThePlaneOfRotationMeetTwice) {
    const RevolvedSegment segment(BezierCurve({Vec3(1, -1, 0), Vec3(0.8, -0.3, 0), Vec3(1.1, 0.3, 0), Vec3(1, 1, 0)}));
    for (int exponent = 0; exponent <= 18; ++exponent) {
        for (const Real height : {-0.731, 0.0, 0.412}) {
            const Real tilt = exponent == 18 ? 0 : std::pow(10.0, -exponent) / 10;
            const Ray ray = {Vec3(-3, height - 3 * tilt, 0.2), Vec3(1, tilt, 0)};
            EXPECT_EQ(segment.roots(AxisRay(ray, 0)).count, 2)
                << "Tilt " << tilt << ": what becomes of two roots that lie closer together than rounding?";
        }
    }
}

// Sphere-like: a half circle of four cubics through the poles; every line through the ball's middle leaves it.
TEST(RevolvedSegment, JointsLetNothingThrough) {
    const Real k = 4.0 / 3 * std::tan(pi / 8);
    const RevolvedSegment below(BezierCurve({Vec3(0, -1, 0), Vec3(k, -1, 0), Vec3(1, -k, 0), Vec3(1, 0, 0)}));
    const RevolvedSegment above(BezierCurve({Vec3(1, 0, 0), Vec3(1, k, 0), Vec3(k, 1, 0), Vec3(0, 1, 0)}));
    for (std::uint64_t i = 0; i < 3000; ++i) {
        Random random(11, {i});
        const Vec3 inside = 0.5 * inCube(random);
        const Real angle = 2 * pi * random.uniform();
        const Vec3 at =
            i % 3 == 0 ? Vec3(0, random.below(2) == 0 ? 1 : -1, 0) : Vec3(std::cos(angle), 0, std::sin(angle));
        const Ray ray = {inside, at - inside};
        const AxisRay axisRay(ray, 0);
        int ahead = 0;
        for (const RevolvedSegment* segment : {&below, &above}) {
            for (const RevolvedRoot& root : segment->roots(axisRay)) ahead += axisRay.tAt(root.distance) > 0 ? 1 : 0;
        }
        EXPECT_EQ(ahead % 2, 1) << "Ray " << i << ": who decides about a root at the very end of a segment?";
    }
}

}  // namespace
}  // namespace caustic
