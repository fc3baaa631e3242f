#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "math/spawn.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"
#include "mesh_sets.h"
#include "shape/triangle.h"
#include "support/chi_square.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// A mesh of one triangle is a triangle.
TEST(TriangleMesh, OneTriangleHitsAsTheShapeDoes) {
    for (std::uint64_t i = 0; i < 3000; ++i) {
        Random random(1, {i});
        const Vec3 a = inCube(random);
        const Vec3 b = inCube(random);
        const Vec3 c = inCube(random);
        MeshData data;
        data.positions = {a, b, c};
        data.triangles = {{0, 1, 2}};
        const TriangleMesh mesh(data);
        const Triangle triangle(a, b, c);
        const Vec3 target = (a + b + c) / 3 + 0.3 * inCube(random);
        const Vec3 origin = 3 * inCube(random);
        const Ray ray = {origin, target - origin};
        const auto expected = triangle.intersect(ray);
        const auto found = mesh.intersect(ray);
        ASSERT_EQ(found.has_value(), expected.has_value());
        if (!found) continue;
        EXPECT_EQ(found->t, expected->t);
        EXPECT_EQ(found->uv, expected->uv);
        EXPECT_TRUE(found->point.isApprox(expected->point, 1e-14));
        EXPECT_TRUE(found->ng.isApprox(expected->ng, 1e-14));
        EXPECT_EQ(found->magnitude, expected->magnitude);
    }
}

// uv is linear on a triangle: moving along dpdu changes u alone, by as much.
TEST(TriangleMesh, TangentsAreTheDerivativesByTheFilesCoordinates) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        MeshData data;
        data.positions = {inCube(random), inCube(random), inCube(random)};
        data.triangles = {{0, 1, 2}};
        for (int k = 0; k < 3; ++k) data.uvs.push_back(inCube(random).head<2>());
        data.uvCorners = {{0, 1, 2}};
        const TriangleMesh mesh(data);
        const Hit at = mesh.hitAt({{1, 0.2, 0.3}, 0});
        EXPECT_TRUE(at.uv.isApprox(0.5 * data.uvs[0] + 0.2 * data.uvs[1] + 0.3 * data.uvs[2], 1e-13));
        for (int corner = 1; corner < 3; ++corner) {
            const Vec2 step = data.uvs[static_cast<std::size_t>(corner)] - data.uvs[0];
            const Vec3 expected = data.positions[static_cast<std::size_t>(corner)] - data.positions[0];
            const Vec3 moved = step.x() * at.dpdu + step.y() * at.dpdv;
            EXPECT_LT((moved - expected).norm(), 1e-9 * (1 + at.dpdu.norm() + at.dpdv.norm()));
        }
    }
}

// A ray that leaves a hit point doesn't meet the triangle that it left: the rule of chapter 02 holds for meshes.
TEST(TriangleMesh, RaysThatLeaveItDoNotMeetItWhereTheyStart) {
    for (const Real scale : {1e-3, 1.0, 1e3, 1e6}) {
        MeshData data = bumpySphere(2000);
        for (Vec3& position : data.positions) position = scale * (position + Vec3(0.3, -0.7, 0.5));
        const TriangleMesh mesh(data);
        for (std::uint64_t i = 0; i < 5000; ++i) {
            Random random(3, {i});
            const Vec3 origin = scale * (3 * inCube(random) + Vec3(0.3, -0.7, 0.5));
            const auto hit = mesh.intersect({origin, inCube(random)});
            if (!hit) continue;
            const Ray away = spawnRay(*hit, hit->ng + 0.9 * inCube(random).normalized());
            const auto again = mesh.intersect(away);
            if (again) {
                EXPECT_GT(again->t * away.direction.norm(), 1e-9 * scale) << "self-hit at scale " << scale;
            }
        }
    }
}

// Points per triangle are proportional to its area.
TEST(TriangleMesh, SamplesItsAreaEvenly) {
    const TriangleMesh mesh(bumpySphere(60));
    const MeshData& data = mesh.data();
    Real whole = 0;
    for (const std::uint32_t triangle : trianglesWithArea(data)) whole += twiceArea(data, triangle).norm() / 2;
    constexpr int samples = 100'000;
    std::vector<double> counts(data.triangles.size(), 0);
    std::vector<double> expected;
    for (std::uint32_t i = 0; i < data.triangles.size(); ++i) {
        expected.push_back(samples * twiceArea(data, i).norm() / 2 / whole);
    }
    for (std::uint64_t i = 0; i < samples; ++i) {
        Random random(4, {i});
        const Real u = random.uniform();
        const auto sample = mesh.sampleArea({u, random.uniform()});
        ASSERT_TRUE(sample.has_value());
        EXPECT_NEAR(sample->pdfA * whole, 1, 1e-12);
        EXPECT_EQ(mesh.pdfA(sample->at), sample->pdfA);
        // Which triangle: the one whose plane holds the point and whose normal it has.
        std::size_t nearest = 0;
        Real least = 1e30;
        for (std::uint32_t k = 0; k < data.triangles.size(); ++k) {
            const auto [a, b, c] = data.corners(k);
            const Vec3 normal = (b - a).cross(c - a).normalized();
            const Real off = std::abs(normal.dot(sample->at.point - a)) + (normal - sample->at.ng).norm();
            if (off < least) {
                least = off;
                nearest = k;
            }
        }
        ++counts[nearest];
    }
    EXPECT_GT(test::chiSquareProbability(counts, expected), 1e-6);
}

// A sphere's normals are known; each weighting comes closer the finer the mesh.
TEST(VertexNormals, ConvergeToTheSurfaces) {
    for (const NormalWeight weight : {NormalWeight::Mean, NormalWeight::Area, NormalWeight::Angle}) {
        Real before = 1;
        for (const std::uint32_t triangles : {200U, 800U, 3200U}) {
            MeshData data = bumpySphere(triangles);
            for (Vec3& position : data.positions) position.normalize();
            const auto normals = vertexNormals(data, weight);
            Real worst = 0;
            for (std::size_t i = 0; i < normals.size(); ++i) {
                // The seam's vertices have triangles on one side only, the poles in one corner.
                const Vec3& place = data.positions[i];
                if (place.x() > 0 && std::abs(place.z()) < 1e-9) continue;
                if (normals[i] == Vec3::Zero() || std::abs(place.y()) > 0.999) continue;
                worst = std::max(worst, std::acos(std::min(Real(1), std::abs(normals[i].dot(place)))));
            }
            EXPECT_LT(worst, 0.6 * before);
            before = worst;
        }
    }
}

}  // namespace
}  // namespace caustic
