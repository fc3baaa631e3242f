#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/process.h"
#include "failures/closed_mesh.h"
#include "failures/leaks.h"
#include "failures/print_leaks.h"
#include "shape/cramer.h"
#include "shape/triangle.h"
#include "shape/watertight.h"
#include "support/paths.h"

namespace caustic {
namespace {

TriangleMethod methodNamed(const std::string& name) {
    for (const TriangleMethod& method : triangleMethods()) {
        if (method.name == name) return method;
    }
    throw std::logic_error("no method " + name);
}

TEST(Watertight, NoRayLeaksThroughAnEdgeOrAVertex) {
    const TriangleMethod watertight = methodNamed("watertight");
    EXPECT_EQ(countLeaks(watertight, Aim::Edges, 500'000, 1, 2).failures, 0);
    EXPECT_EQ(countLeaks(watertight, Aim::Vertices, 500'000, 2, 2).failures, 0);
}

TEST(Watertight, CramersRuleLeaksOnTheSameRays) {
    const TriangleMethod cramer = methodNamed("Cramer's rule");
    EXPECT_GT(countLeaks(cramer, Aim::Edges, 100'000, 1, 2).failures, 100);
    EXPECT_GT(countLeaks(cramer, Aim::Vertices, 100'000, 2, 2).failures, 100);
}

// Why the build says -ffp-contract=off.
TEST(Watertight, FusedProductsLeakOnTheSameRays) {
    const TriangleMethod fused = methodNamed("watertight with fused products");
    EXPECT_GT(countLeaks(fused, Aim::Edges, 100'000, 1, 2).failures, 100);
}

TEST(Watertight, CountsDoNotDependOnThreads) {
    const TriangleMethod cramer = methodNamed("Cramer's rule");
    EXPECT_EQ(countLeaks(cramer, Aim::Edges, 50'000, 3, 1).failures,
              countLeaks(cramer, Aim::Edges, 50'000, 3, 3).failures);
}

// Why the sign of t is taken from the exact volume where rounding could have changed it.
TEST(Watertight, SliversAreNotHitWhereTheyWereLeft) {
    for (const Real width : {1e-2, 1e-4, 1e-6, 1e-8}) {
        EXPECT_EQ(countSliverSelfHits(methodNamed("watertight"), width, 50'000, 7).failures, 0) << width;
    }
    for (const char* const fragile : {"Cramer's rule", "watertight as published"}) {
        EXPECT_GT(countSliverSelfHits(methodNamed(fragile), 1e-4, 50'000, 7).failures, 50) << fragile;
    }
}

TEST(PrintLeaks, TellsEveryMethodAndAim) {
    std::ostringstream out;
    printLeaks(20'000, 8, 2, out);
    const auto list = nlohmann::json::parse(out.str());
    ASSERT_EQ(list.size(), 2 * triangleMethods().size());
    EXPECT_EQ(list[1]["method"], "Cramer's rule");
    EXPECT_EQ(list[1]["aim"], "vertices");
    EXPECT_EQ(list[1]["rays"], 20000);
    EXPECT_EQ(list[1]["leaks"], countLeaks(methodNamed("Cramer's rule"), Aim::Vertices, 20000, 8, 2).failures);
}

TEST(PrintLeaks, RefusesWhatIsNoNumberOfRays) {
    for (const char* const bad : {"", "0", "-5", "1e6", "many", "1000000001", "99999999999999999999"}) {
        const ProcessResult result = *runProcess({test::chapterProgram(), "--leaks", bad});
        EXPECT_EQ(result.exitCode, 2) << bad;
        EXPECT_NE(result.output.find("a whole number from 1 to 1000000000"), std::string::npos) << result.output;
        EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << result.output;
    }
}

// Each edge of the generator's meshes is shared by exactly two triangles, which run along it in opposite directions,
// and Euler's formula holds: V - E + F = 2.
TEST(Watertight, RandomMeshesAreClosed) {
    for (int i = 0; i < 100; ++i) {
        Random random(4, {static_cast<std::uint64_t>(i)});
        const ClosedMesh mesh = randomClosedMesh(random);
        EXPECT_EQ(mesh.triangles.size(), 80U);
        EXPECT_EQ(mesh.vertices.size() - mesh.edges.size() + mesh.triangles.size(), 2U);
        EXPECT_EQ(2 * mesh.edges.size(), 3 * mesh.triangles.size());
        // A ray from inside crosses the surface an odd number of times; its bumps can make that 3.
        int crossings = 0;
        const Vec3 origin = mesh.pointInside(random);
        const Ray ray = {origin, randomDirection(random)};
        for (int t = 0; t < 80; ++t) {
            const auto [a, b, c] = mesh.corners(t);
            crossings += intersectWatertight(ShearedRay(ray), a, b, c) ? 1 : 0;
        }
        EXPECT_EQ(crossings % 2, 1);
    }
}

// Away from edges the two tests solve the same equations.
TEST(Watertight, AgreesWithCramersRule) {
    int hits = 0;
    for (int i = 0; i < 200000; ++i) {
        Random random(5, {static_cast<std::uint64_t>(i)});
        const Vec3 a = randomInBall(random);
        const Vec3 b = randomInBall(random);
        const Vec3 c = randomInBall(random);
        const Vec3 origin = 3 * randomDirection(random);
        const Ray ray = {origin, (a + b + c) / 3 + 0.5 * randomInBall(random) - origin};
        const auto cramer = intersectCramer(ray, a, b, c);
        const auto watertight = intersectWatertight(ShearedRay(ray), a, b, c);
        if (cramer.has_value() != watertight.has_value()) {
            // Then the hit is on an edge, to within rounding.
            const TriangleHit& hit = cramer ? *cramer : *watertight;
            EXPECT_LE(std::min({hit.b1, hit.b2, 1 - hit.b1 - hit.b2}), 1e-9);
            continue;
        }
        if (!cramer) continue;
        ++hits;
        // The condition of the equations: how far the ray is from running within the triangle.
        const Real condition = 1 / std::abs(ray.direction.dot((b - a).cross(c - a)));
        EXPECT_NEAR(watertight->t, cramer->t, 1e-13 * condition);
        EXPECT_NEAR(watertight->b1, cramer->b1, 1e-13 * condition);
        EXPECT_NEAR(watertight->b2, cramer->b2, 1e-13 * condition);
    }
    EXPECT_GT(hits, 5000);
}

TEST(Watertight, RayWithinTheTriangleHitsNothing) {
    const Triangle triangle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_FALSE(triangle.intersect({Vec3(-1, 0.25, 0), Vec3(1, 0, 0)}));
    EXPECT_FALSE(triangle.intersect({Vec3(-1, 0, 0), Vec3(1, 0, 0)})) << "along an edge";
    EXPECT_FALSE(triangle.intersect({Vec3(0.2, 0.2, 0), Vec3(1, 0.5, 0)})) << "from within";
    EXPECT_FALSE(intersectCramer({Vec3(-1, 0.25, 0), Vec3(1, 0, 0)}, Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
}

// Slivers a million times longer than wide, closed to a thin double wedge: rays along it from inside don't get out.
TEST(Watertight, SliversDoNotLeak) {
    for (int i = 0; i < 20000; ++i) {
        Random random(6, {static_cast<std::uint64_t>(i)});
        // A tetrahedron with corners at both ends of a long axis.
        const Vec3 axis = randomDirection(random);
        const Vec3 corners[] = {axis, -axis, 1e-6 * randomDirection(random), 1e-6 * randomDirection(random)};
        const Vec3 origin = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
        const std::size_t from = random.below(4);
        const std::size_t to = (from + 1 + random.below(3)) % 4;
        const Vec3 target = corners[from] + random.uniform() * (corners[to] - corners[from]);
        const ShearedRay ray(Ray{origin, target - origin});
        const bool hit = intersectWatertight(ray, corners[0], corners[1], corners[2]) ||
                         intersectWatertight(ray, corners[0], corners[1], corners[3]) ||
                         intersectWatertight(ray, corners[0], corners[2], corners[3]) ||
                         intersectWatertight(ray, corners[1], corners[2], corners[3]);
        EXPECT_TRUE(hit) << i;
    }
}

}  // namespace
}  // namespace caustic
