#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "support/in_cube.h"
#include "surface/revolved_curve.h"

namespace caustic {
namespace {

using test::inCube;

// One that stays on its side of the axis, one on the other side, and one that crosses it twice.
std::vector<BezierCurve> profiles(Real size) {
    std::vector<BezierCurve> curves;
    for (const std::array<Real, 4>& x :
         {std::array<Real, 4>{0.6, 1.2, 0.3, 0.8}, {-0.6, -1.2, -0.3, -0.8}, {0.9, -1.6, -0.9, 0.7}}) {
        curves.push_back(BezierCurve({size * Vec3(x[0], -1, 0), size * Vec3(x[1], -0.4, 0), size * Vec3(x[2], 0.3, 0),
                                      size * Vec3(x[3], 1, 0)}));
    }
    return curves;
}

Ray randomRay(Random& random, Real size) {
    const Vec3 from = 2.5 * inCube(random);
    const Ray ray = {size * from, inCube(random) - from};
    return {ray.origin, std::pow(10, random.uniform(-1, 1)) * ray.direction};
}

// A line passes the height of each sample's circle once, inside of it or outside; where that changes from one sample to
// the next, both are starts. Truth: the samples themselves.
TEST(Bracketing, StartsLieAroundEachMeeting) {
    constexpr int samples = 64;
    int meetings = 0;
    for (const Real size : {1e-6, 1.0, 1e6}) {
        for (const BezierCurve& profile : profiles(size)) {
            const RevolvedCurve curve(profile, samples);
            for (std::uint64_t i = 0; i < 200; ++i) {
                Random random(2, {i});
                const Ray ray = randomRay(random, size);
                std::vector<Real> expected;
                bool before = false;
                for (int k = 0; k <= samples; ++k) {
                    const Vec3 p = profile.position(Real(k) / samples);
                    const Vec3 at = ray.at((p.y() - ray.origin.y()) / ray.direction.y());
                    const bool inside = std::hypot(at.x(), at.z()) < std::abs(p.x());
                    if (k > 0 && inside != before) {
                        expected.push_back(Real(k - 1) / samples);
                        expected.push_back(Real(k) / samples);
                    }
                    before = inside;
                }
                const NewtonStarts starts = curve.bracketingStarts(ray);
                std::vector<Real> found;
                for (std::size_t k = 0; k < starts.count; ++k) found.push_back(starts.start[k].u);
                std::sort(found.begin(), found.end());
                ASSERT_EQ(found, expected)
                    << "Ray " << i << ", size " << size
                    << ": is there a start on either side of each change, and is a circle's radius "
                       "its profile's |x|?";
                meetings += static_cast<int>(expected.size()) / 2;
            }
        }
    }
    EXPECT_GT(meetings, 1000);
    // The circles of 1, 2 and 3 at the heights 0, 1, 2, and a line that touches the second, or nearly so.
    const RevolvedCurve cone(BezierCurve({Vec3(1, 0, 0), Vec3(3, 2, 0)}), 2);
    for (const auto& [x, first] : {std::pair(2.0, 0.5), std::pair(2 + 1e-9, 0.5), std::pair(2 - 1e-9, 0.0)}) {
        const NewtonStarts starts = cone.bracketingStarts({Vec3(x, 0, 0), Vec3(0, 1, 0)});
        ASSERT_EQ(starts.count, 2U);
        EXPECT_EQ(std::min(starts.start[0].u, starts.start[1].u), first)
            << "A line " << x << " beside the axis: on which side of a circle is the circle itself?";
    }
    const Ray level = {Vec3(-3, 0.2, 0.1), Vec3(1, 0, 0)};
    EXPECT_EQ(RevolvedCurve(profiles(1)[0], samples).bracketingStarts(level).count, 0U)
        << "A ray in a plane of rotation crosses none.";
}

// Each start is a point of the ray in the plane of its sample's circle, and v its angle.
TEST(Bracketing, StartsAreWhereTheRayCrossesThePlaneOfRotation) {
    // A circle of radius 0: its point has no angle, so the line's counts as it is.
    const NewtonStarts around = RevolvedCurve(BezierCurve({Vec3(-1, 0, 0), Vec3(1, 2, 0)}), 2)
                                    .bracketingStarts({Vec3(0.5, -3, 0), Vec3(0, 1, 0)});
    ASSERT_EQ(around.count, 4U);
    for (std::size_t k = 0; k < around.count; ++k) {
        if (around.start[k].u != 0.5) continue;
        EXPECT_NEAR(std::cos(2 * std::numbers::pi * around.start[k].v), 1, 1e-12) << "Is 0 negative?";
    }
    for (const Real size : {1e-6, 1.0, 1e6}) {
        for (const BezierCurve& profile : profiles(size)) {
            const RevolvedCurve curve(profile, 16);
            for (std::uint64_t i = 0; i < 200; ++i) {
                Random random(3, {i});
                const Ray ray = randomRay(random, size);
                const NewtonStarts starts = curve.bracketingStarts(ray);
                for (std::size_t k = 0; k < starts.count; ++k) {
                    const NewtonPoint& start = starts.start[k];
                    const Vec3 onRay = ray.at(start.t) / size;
                    const Vec3 onSurface = curve.evaluate(start.u, start.v).point / size;
                    ASSERT_NEAR(onRay.y(), onSurface.y(), 1e-12)
                        << "At which t does the ray reach the sample's height?";
                    const Real aside = onRay.x() * onSurface.z() - onRay.z() * onSurface.x();
                    ASSERT_NEAR(aside, 0, 1e-12 * (1 + onRay.norm())) << "Which angle has the ray's point?";
                    ASSERT_GE(onRay.x() * onSurface.x() + onRay.z() * onSurface.z(), 0)
                        << "A negative x of the profile lies on the other side of the axis: is the angle turned by "
                           "half?";
                }
            }
        }
    }
}

}  // namespace
}  // namespace caustic
