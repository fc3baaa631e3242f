#include <gtest/gtest.h>

#include <cmath>

#include "shape/ring_cylinder.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

constexpr Real inner = 0.5;
constexpr Real outer = 1;
constexpr Real bottom = -0.4;
constexpr Real top = 0.7;

// From outside, towards the ring, up or down.
Ray rayAtRing(std::uint64_t i) {
    Random random(1, {i});
    Vec3 origin = inCube(random);
    origin += Vec3(origin.x() > 0 ? 2 : -2, 0, origin.z() > 0 ? 2 : -2);
    return {origin, 0.9 * inCube(random) - origin};
}

bool isInSolid(const Vec3& p) {
    const Real r = std::hypot(p.x(), p.z());
    return r >= inner && r <= outer && p.y() >= bottom && p.y() <= top;
}

// By definition: t is in a span when the point at t is in the solid.
TEST(RingCylinder, SpansAreWhereTheRayIsInTheSolid) {
    const RingCylinder ring(inner, outer, bottom, top);
    int twice = 0;
    for (std::uint64_t i = 0; i < 3000; ++i) {
        const Ray ray = rayAtRing(i);
        const RingCylinder::Spans spans = ring.spans(ray);
        twice += spans.count == 2 ? 1 : 0;
        for (Real t = 0.0005; t < 2.5; t += 0.01) {
            bool found = false;
            for (const RingCylinder::Span& span : spans) found = found || (span.enter.t <= t && t <= span.leave.t);
            ASSERT_EQ(found, isInSolid(ray.at(t)))
                << "Ray " << i << " at t = " << t << ": does it come back into the solid behind the hole?";
        }
    }
    EXPECT_GT(twice, 300) << "Many of these rays cross the hole.";
}

// How far a point is from the part of the surface, each part taken as a whole plane or cylinder.
Real distanceFrom(RingCylinder::Part part, const Vec3& p) {
    const Real r = std::hypot(p.x(), p.z());
    switch (part) {
        case RingCylinder::Part::Bottom:
            return std::abs(p.y() - bottom);
        case RingCylinder::Part::Top:
            return std::abs(p.y() - top);
        case RingCylinder::Part::OuterWall:
            return std::abs(r - outer);
        default:
            return std::abs(r - inner);
    }
}

// Where a span begins and ends, the point is on the part of the surface that the crossing names.
TEST(RingCylinder, CrossingsAreOnThePartsThatTheyName) {
    const RingCylinder ring(inner, outer, bottom, top);
    int crossings = 0;
    for (std::uint64_t i = 0; i < 3000; ++i) {
        const Ray ray = rayAtRing(i);
        for (const RingCylinder::Span& span : ring.spans(ray)) {
            for (const RingCylinder::Crossing& crossing : {span.enter, span.leave}) {
                ++crossings;
                ASSERT_LE(distanceFrom(crossing.part, ray.at(crossing.t)), 1e-9)
                    << "Ray " << i << ": which part does a ray cross at the rim of the hole?";
            }
        }
    }
    EXPECT_GT(crossings, 1000);
}

}  // namespace
}  // namespace caustic
