#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/revolved_segment.h"
#include "turned_profiles.h"

namespace caustic {
namespace {

using test::cubicProfile;
using test::equationOf;
using test::rayThroughCube;

constexpr Real pi = std::numbers::pi;

struct Sized {
    Real size;
    Real height;
};

constexpr std::array<Sized, 5> sizes = {{{1, 0}, {1e-6, 0}, {1e-20, 0}, {1e6, 0}, {1, 100}}};

// A cubic, one that crosses the axis twice, and other degrees up to the highest.
std::vector<BezierCurve> profilesOf(Real size, Real height) {
    std::vector<BezierCurve> profiles = {cubicProfile({0.6, 1.5, -0.2, 0.8}, size, height),
                                         cubicProfile({0.9, -2.2, -0.7, 0.6}, size, height)};
    for (const int degree : {1, 2, 5, 16}) {
        Random random(13, {static_cast<std::uint64_t>(degree)});
        std::vector<Vec3> points;
        for (int i = 0; i <= degree; ++i) {
            const Real x = random.uniform(-0.5, 2);
            points.push_back(Vec3(size * x, size * (2 * Real(i) / degree - 1) + height, 0));
        }
        profiles.push_back(BezierCurve(points));
    }
    return profiles;
}

// The truth: along the profile in small steps, a change of sign of f is a meeting.
TEST(RevolvedSegment, FindsEveryRoot) {
    int several = 0;
    for (const auto& [size, height] : sizes) {
        for (const BezierCurve& profile : profilesOf(size, height)) {
            const RevolvedSegment segment(profile);
            std::vector<Vec3> points;
            for (int k = 0; k <= 10000; ++k) points.push_back(profile.position(Real(k) / 10000));
            for (std::uint64_t i = 0; i < 150; ++i) {
                const AxisRay ray(rayThroughCube(7, i, size, height), height);
                int changes = 0;
                bool before = equationOf<Real>(ray, points[0].x(), points[0].y()) < 0;
                for (const Vec3& p : points) {
                    const bool below = equationOf<Real>(ray, p.x(), p.y()) < 0;
                    changes += below != before ? 1 : 0;
                    before = below;
                }
                ASSERT_EQ(segment.roots(ray).count, changes)
                    << "Ray " << i << ", degree " << profile.degree() << ", size " << size << ", height " << height
                    << ": are both halves searched?";
                several += changes > 1 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(several, 400) << "Many of these rays meet the surface more than once.";
}

TEST(RevolvedSegment, RootsAreWhereLineAndSurfaceMeet) {
    for (const auto& [size, height] : sizes) {
        for (const BezierCurve& profile : profilesOf(size, height)) {
            const RevolvedSegment segment(profile);
            for (std::uint64_t i = 0; i < 200; ++i) {
                const Ray ray = rayThroughCube(7, i, size, height);
                const AxisRay axisRay(ray, height);
                Real before = 0;
                for (const RevolvedRoot& root : segment.roots(axisRay)) {
                    const Vec3 onLine = ray.at(axisRay.tAt(root.distance));
                    const Vec3 onProfile = profile.position(root.u);
                    ASSERT_NEAR(std::hypot(onLine.x(), onLine.z()), std::abs(onProfile.x()), 1e-12 * (size + height))
                        << "Ray " << i << ": is the root's u that of the whole segment, or of a half?";
                    ASSERT_NEAR(onLine.y(), onProfile.y(), 1e-12 * (size + height));
                    ASSERT_GE(root.u, before) << "Ray " << i << ": in which order do the halves come?";
                    before = root.u;
                }
            }
        }
    }
}

// In a plane of rotation the equation is a square, and has no change of sign; two meetings there are all the same.
TEST(RevolvedSegment, RaysNearThePlaneOfRotationMeetTwice) {
    for (const auto& [size, height] : sizes) {
        const RevolvedSegment segment(cubicProfile({1, 0.8, 1.1, 1}, size, height));
        for (int exponent = 0; exponent <= 18; ++exponent) {
            for (const Real place : {-0.731, 0.0, 0.412}) {
                const Real tilt = exponent == 18 ? 0 : std::pow(10.0, -exponent) / 10;
                const Ray ray = {size * Vec3(-3, place - 3 * tilt, 0.2) + Vec3(0, height, 0), Vec3(1, tilt, 0)};
                EXPECT_EQ(segment.roots(AxisRay(ray, height)).count, 2)
                    << "Tilt " << tilt << ", size " << size
                    << ": what becomes of two roots that lie closer together than rounding?";
            }
        }
    }
}

// Sphere-like: a half circle of two cubics through the poles; every line through the ball's middle leaves it.
TEST(RevolvedSegment, JointsLetNothingThrough) {
    const Real k = 4.0 / 3 * std::tan(pi / 8);
    for (const auto& [size, height] : {Sized{1, 0}, Sized{1e-6, 0}, Sized{1000, 0}, Sized{1, 100}, Sized{1, -3}}) {
        const auto at = [size = size, height = height](Real x, Real y) { return Vec3(size * x, size * y + height, 0); };
        const RevolvedSegment below(BezierCurve({at(0, -1), at(k, -1), at(1, -k), at(1, 0)}));
        const RevolvedSegment above(BezierCurve({at(1, 0), at(1, k), at(k, 1), at(0, 1)}));
        for (std::uint64_t i = 0; i < 3000; ++i) {
            Random random(11, {i});
            const Vec3 inside = 0.5 * test::inCube(random);
            const Real angle = 2 * pi * random.uniform();
            const Vec3 joint =
                i % 3 == 0 ? Vec3(0, random.below(2) == 0 ? 1 : -1, 0) : Vec3(std::cos(angle), 0, std::sin(angle));
            const Ray ray = {size * inside + Vec3(0, height, 0), size * (joint - inside)};
            const AxisRay axisRay(ray, height);
            int ahead = 0;
            for (const RevolvedSegment* segment : {&below, &above}) {
                for (const RevolvedRoot& root : segment->roots(axisRay))
                    ahead += axisRay.tAt(root.distance) > 0 ? 1 : 0;
            }
            ASSERT_EQ(ahead % 2, 1) << "Ray " << i << ", radius " << size << ", height " << height
                                    << ": who decides about a root at the very end of a segment?";
        }
    }
}

// A generator of a cylinder or a cone: f is zero all along, up to rounding. What is found there is arbitrary, and
// little.
TEST(RevolvedSegment, SearchEndsForALineWithinTheSurface) {
    for (const auto& [size, height] : sizes) {
        for (const Real top : {0.7, 0.3, -0.4}) {
            const auto at = [size = size, height = height](Real x, Real y) {
                return Vec3(size * x, size * y + height, 0);
            };
            const Real step = (top - 0.7) / 3;
            const RevolvedSegment straight(
                BezierCurve({at(0.7, -1), at(0.7 + step, -1.0 / 3), at(0.7 + 2 * step, 1.0 / 3), at(top, 1)}));
            for (const Real angle : {0.0, 0.7, 2.9}) {
                const auto turned = [&](const Vec3& p) {
                    return Vec3(p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle));
                };
                const Vec3 from = turned(at(0.7, -1));
                const Ray ray = {from, turned(at(top, 1)) - from};
                EXPECT_LE(straight.roots(AxisRay(ray, height)).count, 6)
                    << "top " << top << ", size " << size << ": when is halving over, when no sign is certain?";
            }
        }
    }
}

}  // namespace
}  // namespace caustic
