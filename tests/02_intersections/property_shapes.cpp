#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "leaving.h"
#include "shape/sphere.h"
#include "shape_catalogue.h"

namespace caustic {
namespace {

// Every shape of the library goes through the contract that shape.h states.
class ShapeContract : public testing::TestWithParam<CatalogueShape> {
protected:
    const Shape& shape() const { return *GetParam().shape; }

    // Rays from all around, of all lengths of direction; about half of them hit.
    template <typename Check>
    void forRandomRays(int count, const Check& check) const {
        for (int i = 0; i < count; ++i) {
            Random random(1, {static_cast<std::uint64_t>(i)});
            const Vec3 origin = 4 * randomDirection(random);
            const Vec3 target = 1.2 * randomInBall(random);
            check(Ray{origin, (target - origin) * std::pow(10, random.uniform(-3, 3))});
        }
    }

    template <typename Check>
    void forRandomHits(int count, const Check& check) const {
        int hits = 0;
        forRandomRays(count, [&](const Ray& ray) {
            const std::optional<Hit> hit = shape().intersect(ray);
            if (!hit) return;
            ++hits;
            check(ray, *hit);
        });
        // The sliver is hit by chance about once in ten thousand; stability tests aim at it.
        if (GetParam().name == "sliver") return;
        EXPECT_GT(hits, count / 20);
    }
};

TEST_P(ShapeContract, OccludedAgreesWithIntersect) {
    forRandomRays(20000, [&](const Ray& ray) { EXPECT_EQ(shape().occluded(ray), shape().intersect(ray).has_value()); });
}

TEST_P(ShapeContract, HitLiesOnTheRayAndInTheBounds) {
    const Bounds3 bounds = shape().bounds();
    forRandomHits(20000, [&](const Ray& ray, const Hit& hit) {
        const Real rounding = 1e-12 * (hit.magnitude + ray.origin.norm());
        // Along a surface seen edge-on t is ill-conditioned; across the ray the point must fit all the same.
        const Vec3 offRay = (hit.point - ray.origin).cross(ray.direction.normalized());
        EXPECT_LE(offRay.norm(), rounding / std::abs(hit.ng.dot(ray.direction.normalized())));
        EXPECT_LE(bounds.exteriorDistance(hit.point), rounding);
    });
}

TEST_P(ShapeContract, NormalsAreUnitAndPerpendicularToTangents) {
    forRandomHits(20000, [&](const Ray&, const Hit& hit) {
        EXPECT_NEAR(hit.ng.norm(), 1, 1e-14);
        EXPECT_NEAR(hit.ns.norm(), 1, 1e-14);
        EXPECT_GT(hit.ng.dot(hit.ns), 0);
        const Vec3 across = hit.dpdu.cross(hit.dpdv);
        EXPECT_NEAR(std::abs(across.normalized().dot(hit.ng)), 1, 1e-9) << hit.point.transpose();
    });
}

// What ends a search must not change what it finds: tMax a little past the hit finds it, a little before finds nothing,
// tMin past it finds what is behind.
TEST_P(ShapeContract, RangeOfTIsRespected) {
    forRandomHits(5000, [&](const Ray& ray, const Hit& hit) {
        const Real t = hit.t;
        Ray part = ray;
        part.tMax = t * (1 + 1e-9);
        ASSERT_TRUE(shape().intersect(part));
        EXPECT_EQ(shape().intersect(part)->t, t);
        part.tMax = t;
        EXPECT_FALSE(shape().intersect(part)) << "Is a hit at tMax itself left out?";
        part = ray;
        part.tMin = t * (1 + 1e-9);
        const std::optional<Hit> behind = shape().intersect(part);
        EXPECT_TRUE(!behind || behind->t > t);
    });
}

// A ray's direction is measured in its own length: scaled by k, t is divided by k and the point stays.
TEST_P(ShapeContract, LengthOfDirectionOnlyScalesT) {
    forRandomHits(5000, [&](const Ray& ray, const Hit& hit) {
        // A power of two scales without rounding.
        const std::optional<Hit> same = shape().intersect({ray.origin, 0.125 * ray.direction});
        ASSERT_TRUE(same);
        EXPECT_DOUBLE_EQ(same->t, 8 * hit.t);
        EXPECT_EQ(same->point, hit.point);
    });
}

// Between two hits a little apart the point moves as the tangents say.
TEST_P(ShapeContract, TangentsAreDerivativesByUv) {
    int compared = 0;
    forRandomHits(5000, [&](const Ray& ray, const Hit& hit) {
        const Vec3 sideways = 1e-6 * ray.direction.norm() * ray.direction.unitOrthogonal();
        const std::optional<Hit> next = shape().intersect({ray.origin, ray.direction + sideways});
        // A neighbour across an edge or the seam of u has other parameters.
        if (!next || (next->ng - hit.ng).norm() > 1e-4 || (next->uv - hit.uv).norm() > 1e-2) return;
        const Vec2 step = next->uv - hit.uv;
        const Vec3 expected = step.x() * hit.dpdu + step.y() * hit.dpdv;
        const Vec3 moved = next->point - hit.point;
        EXPECT_LE((moved - expected).norm(), 1e-3 * moved.norm() + 1e-9) << hit.uv.transpose();
        ++compared;
    });
    EXPECT_TRUE(compared > 100 || GetParam().name == "sliver") << compared;
}

TEST_P(ShapeContract, ClosedShapesAreCrossedAnEvenNumberOfTimes) {
    if (!GetParam().closed) return;
    forRandomRays(5000, [&](Ray ray) {
        int crossings = 0;
        for (std::optional<Hit> hit = shape().intersect(ray); hit; hit = shape().intersect(ray)) {
            const Real facing = hit->ng.dot(ray.direction);
            const bool enters = crossings % 2 == 0;
            EXPECT_TRUE(enters ? facing < 0 : facing > 0) << "From outside it enters first: which way does ng point?";
            ++crossings;
            ray.tMin = hit->t;
        }
        EXPECT_EQ(crossings % 2, 0);
        EXPECT_LE(crossings, 4);
    });
}

TEST_P(ShapeContract, NanInARayHitsNothing) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    forRandomHits(200, [&](const Ray& ray, const Hit&) {
        for (int axis = 0; axis < 3; ++axis) {
            Ray broken = ray;
            broken.origin[axis] = nan;
            EXPECT_FALSE(shape().occluded(broken));
            broken = ray;
            broken.direction[axis] = nan;
            EXPECT_FALSE(shape().occluded(broken));
        }
    });
}

// Points that sampleArea picks are on the surface: a ray at one meets the same point with the same normal and uv.
TEST_P(ShapeContract, SampledPointsAreOnTheSurface) {
    for (int i = 0; i < 2000; ++i) {
        Random random(2, {static_cast<std::uint64_t>(i)});
        const auto sample = shape().sampleArea({random.uniform(), random.uniform()});
        if (!sample) {
            EXPECT_TRUE(!shape().bounded() || GetParam().name == "group");
            return;
        }
        const Vec3 towards = sample->at.ng + 0.3 * randomDirection(random);
        // From a little outside, so that nothing else is in between; the sliver is 1e-4 wide.
        const Ray ray = {sample->at.point + 1e-5 * towards, -towards};
        const std::optional<Hit> hit = shape().intersect(ray);
        if (!hit || (hit->ng - sample->at.ng).norm() > 1e-4) continue;  // aside an edge
        EXPECT_NEAR(hit->t, 1e-5, 1e-9);
        EXPECT_LE((hit->point - sample->at.point).norm(), 1e-9);
        EXPECT_LE((hit->uv - sample->at.uv).norm(), 1e-4);
        EXPECT_NEAR(shape().pdfA(*hit), sample->pdfA, 1e-6 * sample->pdfA);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShapeContract, testing::ValuesIn(shapeCatalogue()), [](const auto& one) {
    std::string name = one.param.name;
    for (char& c : name) c = c == ' ' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace caustic
