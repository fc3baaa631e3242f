#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "shape/ring_cylinder.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// A ring in units of `size`, and rays for it.
struct RingCase {
    Real inner;
    Real outer;
    Real bottom;
    Real top;
    Real size;

    RingCylinder ring() const { return {size * inner, size * outer, size * bottom, size * top}; }

    // From outside towards the ring, or from anywhere in any direction; every fifth level, every fifth along the axis.
    Ray ray(std::uint64_t i) const {
        Random random(1, {i});
        const Vec3 stretch(outer, (top - bottom) / 2, outer);
        const Vec3 center(0, (top + bottom) / 2, 0);
        Vec3 origin = inCube(random);
        Vec3 target = 0.9 * inCube(random);
        if (i % 2 == 0) origin += Vec3(origin.x() > 0 ? 2 : -2, 0, origin.z() > 0 ? 2 : -2);
        if (i % 5 == 0) target.y() = origin.y();
        if (i % 5 == 1) target = origin + Vec3(0, i % 10 == 1 ? 2 : -2, 0);
        const Vec3 from = center + stretch.cwiseProduct(origin);
        const Vec3 way = stretch.cwiseProduct(target - origin);
        // The line counts, not the ray's ends.
        return {size * from, size * way, 0.3, 0.6};
    }

    bool isInSolid(const Vec3& p) const {
        const Real r = std::hypot(p.x(), p.z());
        return r >= size * inner && r <= size * outer && p.y() >= size * bottom && p.y() <= size * top;
    }

    // How far a point is from the part of the surface, each part taken as a whole plane or cylinder.
    Real distanceFrom(RingCylinder::Part part, const Vec3& p) const {
        const Real r = std::hypot(p.x(), p.z());
        switch (part) {
            case RingCylinder::Part::Bottom:
                return std::abs(p.y() - size * bottom);
            case RingCylinder::Part::Top:
                return std::abs(p.y() - size * top);
            case RingCylinder::Part::OuterWall:
                return std::abs(r - size * outer);
            default:
                return inner > 0 ? std::abs(r - size * inner) : size;
        }
    }
};

constexpr std::array<RingCase, 5> rings = {{{0.5, 1, -0.4, 0.7, 1},
                                            {0.5, 1, -0.4, 0.7, 1e-6},
                                            {0.9, 1, 5, 5.3, 1e6},
                                            {0, 1, -3, -1, 1},
                                            {0.1, 2, -0.1, 0.1, 1}}};

// By definition: t is in a span when the point at t is in the solid.
TEST(RingCylinder, SpansAreWhereTheRayIsInTheSolid) {
    int twice = 0;
    for (const RingCase& one : rings) {
        const RingCylinder ring = one.ring();
        for (std::uint64_t i = 0; i < 1500; ++i) {
            const Ray ray = one.ray(i);
            const RingCylinder::Spans spans = ring.spans(ray);
            ASSERT_LE(spans.count, 2);
            twice += spans.count == 2 ? 1 : 0;
            for (Real t = -2.0005; t < 2.5; t += 0.01) {
                bool found = false;
                for (const RingCylinder::Span& span : spans) found = found || (span.enter.t <= t && t <= span.leave.t);
                ASSERT_EQ(found, one.isInSolid(ray.at(t)))
                    << "Ray " << i << " at t = " << t << ": does it come back into the solid behind the hole?";
            }
        }
    }
    EXPECT_GT(twice, 1000) << "Many of these rays cross the hole.";
    const Ray throughTheAxis = {Vec3(-3, 0.5, 0), Vec3(1, 0, 0)};
    EXPECT_EQ(RingCylinder(0, 1, 0, 1).spans(throughTheAxis).count, 1) << "Has a solid without a hole two pieces?";
    // From the bottom's plane at the rim of the hole, which belongs to the hole, on to the wall behind it; and back.
    const RingCylinder ring(1, 2, 0, 5);
    const RingCylinder::Spans into = ring.spans({Vec3(-2, -1, 0), Vec3(1, 1, 0)});
    ASSERT_EQ(into.count, 1) << "Is a single point at the rim a piece?";
    EXPECT_EQ(into.span[0].enter.t, 3);
    const RingCylinder::Spans back = ring.spans({Vec3(2, 3, 0), Vec3(-1, -1, 0)});
    ASSERT_EQ(back.count, 1) << "Is a single point at the rim a piece?";
    EXPECT_EQ(back.span[0].leave.t, 1);
}

// Where a span begins and ends, the point is on the part of the surface that the crossing names.
TEST(RingCylinder, CrossingsAreOnThePartsThatTheyName) {
    int crossings = 0;
    for (const RingCase& one : rings) {
        const RingCylinder ring = one.ring();
        for (std::uint64_t i = 0; i < 1500; ++i) {
            const Ray ray = one.ray(i);
            if (ray.direction.x() == 0 && ray.direction.z() == 0) continue;
            Real before = -1e30;
            for (const RingCylinder::Span& span : ring.spans(ray)) {
                ASSERT_LT(before, span.enter.t) << "Ray " << i << ": in which order do the pieces come?";
                ASSERT_LE(span.enter.t, span.leave.t) << "Ray " << i;
                before = span.leave.t;
                for (const RingCylinder::Crossing& crossing : {span.enter, span.leave}) {
                    ++crossings;
                    ASSERT_LE(one.distanceFrom(crossing.part, ray.at(crossing.t)), 1e-9 * one.size)
                        << "Ray " << i << ": which part does a ray cross at the rim of the hole?";
                }
            }
        }
    }
    EXPECT_GT(crossings, 5000);
}

}  // namespace
}  // namespace caustic
