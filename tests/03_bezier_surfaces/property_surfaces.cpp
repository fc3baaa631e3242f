#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/error.h"
#include "core/random.h"
#include "failures/patch_cases.h"
#include "math/spawn.h"
#include "measures/triangle_tree.h"
#include "patch_file.h"
#include "revolution_cases.h"
#include "support/in_cube.h"
#include "support/paths.h"
#include "surface/surface_of_revolution.h"
#include "surface/tessellation.h"

namespace caustic {
namespace {

using test::inCube;

constexpr Real pi = std::numbers::pi;

// A half circle of two cubics around the origin: within 3e-4 of a ball.
std::vector<BezierCurve> nearlyHalfCircle() {
    const Real k = 4.0 / 3 * std::tan(pi / 8);
    return {BezierCurve({Vec3(0, -1, 0), Vec3(k, -1, 0), Vec3(1, -k, 0), Vec3(1, 0, 0)}),
            BezierCurve({Vec3(1, 0, 0), Vec3(1, k, 0), Vec3(k, 1, 0), Vec3(0, 1, 0)})};
}

std::vector<std::shared_ptr<const Shape>> everyShape() {
    std::vector<std::shared_ptr<const Shape>> shapes;
    for (const NamedProfile& named : difficultProfiles()) {
        shapes.push_back(std::make_shared<SurfaceOfRevolution>(named.profile));
    }
    for (const BezierPatch& patch : difficultPatches()) shapes.push_back(std::make_shared<PatchSurface>(patch));
    return shapes;
}

// A ball's normal is its point; the surface is within 3e-4 of one, and so is its slope within 3e-3.
TEST(SurfaceOfRevolution, NearlyABall) {
    const SurfaceOfRevolution surface(nearlyHalfCircle());
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(1, {i});
        const Vec3 from = 3 * inCube(random).normalized();
        const Ray ray = {from, 0.5 * inCube(random) - from};
        const auto hit = surface.intersect(ray);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->point.norm(), 1, 3e-4);
        EXPECT_LE((hit->ng - hit->point).norm(), 4e-3) << "Does the normal point out of a closed surface?";
        EXPECT_LE((ray.at(hit->t) - hit->point).norm(), 1e-12);
    }
}

TEST(SurfaceOfRevolution, NormalPointsOutWhateverWayTheProfileRuns) {
    std::vector<BezierCurve> downwards;
    const auto upwards = nearlyHalfCircle();
    for (auto segment = upwards.rbegin(); segment != upwards.rend(); ++segment) {
        downwards.emplace_back(std::vector<Vec3>(segment->controlPoints().rbegin(), segment->controlPoints().rend()));
    }
    const SurfaceOfRevolution surface(downwards);
    EXPECT_GT(surface.intersect({Vec3(3, 0.2, 0.1), Vec3(-1, 0, 0)})->ng.x(), 0.9);
    EXPECT_LT(surface.normal(0, 0.3).y(), -0.999) << "on the lower pole";
    EXPECT_GT(surface.normal(1, 0.3).y(), 0.999) << "on the upper pole";
}

TEST(EveryShape, KeepsTheContract) {
    const auto shapes = everyShape();
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        const Shape& shape = *shapes[s];
        const Bounds3 box = shape.bounds();
        const Real radius = box.diagonal().norm() / 2;
        int hits = 0;
        for (std::uint64_t i = 0; i < 2000; ++i) {
            Random random(2, {s, i});
            const Vec3 from = box.center() + 1.5 * radius * inCube(random).normalized();
            const Vec3 to = box.center() + 0.5 * radius * inCube(random);
            const Ray ray = {from, (to - from) * std::pow(10, random.uniform(-3, 3))};
            const auto hit = shape.intersect(ray);
            EXPECT_EQ(shape.occluded(ray), hit.has_value());
            if (!hit) continue;
            ++hits;
            EXPECT_LE(box.exteriorDistance(hit->point), 1e-12 * radius);
            const Real cosine = std::abs(hit->ng.dot(ray.direction.normalized()));
            EXPECT_LE((ray.at(hit->t) - hit->point).norm(), 1e-12 * radius / std::max(cosine, Real(1e-3)));
            EXPECT_NEAR(hit->ng.norm(), 1, 1e-12);
            EXPECT_EQ(hit->ng, hit->ns);
            const Vec3 across = hit->dpdu.cross(hit->dpdv);
            if (across.norm() > 1e-6 * radius * radius) {
                EXPECT_GT(across.normalized().dot(hit->ng), 1 - 1e-9) << "shape " << s << ", ray " << i;
            }
            Ray part = ray;
            part.tMax = hit->t;
            EXPECT_FALSE(shape.intersect(part) && shape.intersect(part)->t >= hit->t) << "tMax itself is left out";
            part = ray;
            part.tMin = hit->t;
            const auto behind = shape.intersect(part);
            EXPECT_TRUE(!behind || behind->t > hit->t);
        }
        EXPECT_GT(hits, 100) << "shape " << s;
    }
}

// Rays that leave a point by the course's rule don't meet the surface where they started: a convex one not at all.
TEST(SurfaceOfRevolution, LeavingMeetsNothingNearby) {
    const SurfaceOfRevolution surface(nearlyHalfCircle());
    for (std::uint64_t i = 0; i < 5000; ++i) {
        Random random(3, {i});
        const Vec3 from = 3 * inCube(random).normalized();
        const auto hit = surface.intersect({from, 0.9 * inCube(random) - from});
        if (!hit) continue;
        Vec3 way = inCube(random);
        if (way.dot(hit->ng) < 0) way = -way;
        way += 1e-6 * hit->ng;
        EXPECT_FALSE(surface.occluded(spawnRay(*hit, way))) << "ray " << i;
    }
}

// n × n cells of a patch, two triangles each.
IndexedTriangles gridOf(const BezierPatch& patch, std::uint32_t n) {
    IndexedTriangles mesh;
    for (std::uint32_t i = 0; i <= n; ++i) {
        for (std::uint32_t j = 0; j <= n; ++j) mesh.vertices.push_back(patch.evaluate(Real(i) / n, Real(j) / n).point);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i * (n + 1) + j;
            const std::uint32_t c = a + n + 2;
            mesh.triangles.push_back({a, a + n + 1, c});
            mesh.triangles.push_back({a, c, a + 1});
        }
    }
    return mesh;
}

// Both ways to estimate an area agree: the mean of 1/pdf over samples, and a fine tessellation's area.
TEST(EveryShape, SamplesByArea) {
    const auto meshArea = [](const IndexedTriangles& mesh) {
        Real area = 0;
        for (const auto& [a, b, c] : mesh.triangles) {
            area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
        }
        return area;
    };
    const auto check = [](const Shape& shape, Real area) {
        Real sum = 0;
        constexpr int samples = 20000;
        for (int i = 0; i < samples; ++i) {
            Random random(4, {static_cast<std::uint64_t>(i)});
            const Real u = random.uniform();
            const auto sample = shape.sampleArea({u, random.uniform()});
            ASSERT_TRUE(sample);
            EXPECT_GT(sample->pdfA, 0);
            EXPECT_NEAR(shape.pdfA(sample->at), sample->pdfA, 1e-9 * sample->pdfA);
            sum += 1 / sample->pdfA / samples;
        }
        EXPECT_NEAR(sum, area, 0.01 * area);
    };
    const SurfaceOfRevolution vase(plainVase());
    check(vase, meshArea(tessellated(vase, 1e-4)));
    const BezierPatch patch = difficultPatches().front();
    check(PatchSurface(patch), meshArea(gridOf(patch, 200)));
}

// No point of the triangles is farther than the tolerance from the surface: vertices lie on it, and the middle of each
// triangle has the surface within the tolerance on one of the two sides.
TEST(Tessellation, StaysWithinItsTolerance) {
    const SurfaceOfRevolution vase(plainVase());
    for (const Real tolerance : {3e-2, 1e-3}) {
        const IndexedTriangles mesh = tessellated(vase, tolerance);
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
            const Vec3 normal =
                (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized();
            const Ray ray = {middle - 1.001 * tolerance * normal, normal, 0, 2.002 * tolerance};
            EXPECT_TRUE(vase.occluded(ray)) << middle.transpose();
        }
        EXPECT_THROW(tessellated(vase, 0), InputError);
    }
    EXPECT_LT(tessellated(vase, 1e-2).triangles.size(), tessellated(vase, 1e-3).triangles.size());
}

// Rays agree with the t of fine triangles up to these' distance from the surface over the cosine.
TEST(PatchSurface, TrianglesAndPatchAgree) {
    const BezierPatch patch = difficultPatches().front();
    const PatchSurface surface(patch);
    const TriangleTree tree(gridOf(patch, 500));
    int compared = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(5, {i});
        const Vec3 from = Vec3(0.5, 0.5, 0) + 2 * inCube(random).normalized();
        const Ray ray = {from, Vec3(random.uniform(0.1, 0.9), random.uniform(0.1, 0.9), 0) - from};
        const auto hit = surface.intersect(ray);
        const auto t = tree.intersect(ray);
        if (!hit || !t || std::abs(hit->ng.dot(ray.direction.normalized())) < 0.1) continue;
        ++compared;
        EXPECT_NEAR(*t, hit->t, 3e-4);
    }
    EXPECT_GT(compared, 1000);
}

// The teapot's numbers: edges that two patches share have the same control points, bit for bit.
TEST(Teapot, RaysAtSharedEdgesMissNothing) {
    const auto patches = loadPatches((test::sourceDir() / "assets/teapot/teapot.txt").string());
    ASSERT_EQ(patches.size(), 32U);
    struct Edge {
        std::vector<Vec3> points;
        std::vector<std::size_t> patches;
    };
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const BezierPatch& p = patches[k].patch;
        for (int side = 0; side < 4; ++side) {
            std::vector<Vec3> points;
            for (int i = 0; i <= 3; ++i) {
                points.push_back(side < 2 ? p.controlPoint(side == 0 ? 0 : 3, i)
                                          : p.controlPoint(i, side == 2 ? 0 : 3));
            }
            const std::vector<Vec3> turned(points.rbegin(), points.rend());
            const auto same = std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) {
                return edge.points == points || edge.points == turned;
            });
            if (same == edges.end()) {
                edges.push_back({points, {k}});
            } else {
                same->patches.push_back(k);
            }
        }
    }
    int shared = 0;
    int rays = 0;
    int misses = 0;
    for (const Edge& edge : edges) {
        if (edge.patches.size() < 2) continue;
        ++shared;
        const BezierCurve curve(edge.points);
        for (std::uint64_t i = 0; i < 400; ++i) {
            Random random(6, {static_cast<std::uint64_t>(shared), i});
            const Vec3 at = curve.position(random.uniform());
            const Vec3 from = Vec3(0.3, 0, 1.4) + 5 * inCube(random).normalized();
            const ShearedRay ray({from, at - from});
            bool found = false;
            for (const std::size_t k : edge.patches) {
                for (const PatchRoot& root : patchRoots(patches[k].patch, ray)) {
                    const Vec3 normal = PatchSurface(patches[k].patch).normal(root.u, root.v);
                    const Real cosine = std::abs(normal.dot((at - from).normalized()));
                    found = found || std::abs(root.t - 1) * cosine < 1e-12 || std::abs(root.t - 1) < 1e-6;
                }
            }
            ++rays;
            misses += found ? 0 : 1;
        }
    }
    EXPECT_GE(shared, 50) << "32 patches, each with four sides";
    EXPECT_EQ(misses, 0) << "of " << rays;
}

}  // namespace
}  // namespace caustic
