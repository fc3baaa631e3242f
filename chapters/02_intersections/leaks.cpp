#include "leaks.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "closed_mesh.h"
#include "core/parallel.h"
#include "shape/cramer.h"
#include "shape/watertight.h"

namespace caustic {

namespace {

constexpr std::int64_t raysPerMesh = 10000;

bool hitsByCramer(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    return intersectCramer(ray, a, b, c).has_value();
}

bool hitsWatertight(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    return intersectWatertight(ShearedRay(ray), a, b, c).has_value();
}

// What -ffp-contract=fast makes of the textbook's lines: each difference of products, the shear's too, is fused. Then
// a·b − c·d is no longer the negative of c·d − a·b, and the two triangles at an edge may both call it outside.
bool hitsContracted(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const ShearedRay sheared(ray);
    const auto [x, y, z] = sheared.axis;
    const Vec3 fromA = a - ray.origin;
    const Vec3 fromB = b - ray.origin;
    const Vec3 fromC = c - ray.origin;
    const auto shearedX = [&, x = x, z = z](const Vec3& p) { return std::fma(-sheared.shear.x(), p[z], p[x]); };
    const auto shearedY = [&, y = y, z = z](const Vec3& p) { return std::fma(-sheared.shear.y(), p[z], p[y]); };
    const auto fused = [](Real p, Real q, Real r, Real s) { return std::fma(p, q, -(r * s)); };
    const Real u = fused(shearedX(fromC), shearedY(fromB), shearedY(fromC), shearedX(fromB));
    const Real v = fused(shearedX(fromA), shearedY(fromC), shearedY(fromA), shearedX(fromC));
    const Real w = fused(shearedX(fromB), shearedY(fromA), shearedY(fromB), shearedX(fromA));
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const Real determinant = u + v + w;
    if (determinant == 0) return false;
    return ray.reaches(sheared.shear.z() * (u * fromA[z] + v * fromB[z] + w * fromC[z]) / determinant);
}

// One loop a method, so that the test is called as a ray tracer would call it: directly.
template <bool (*hits)(const Ray&, const Vec3&, const Vec3&, const Vec3&)>
std::int64_t countHitsBy(const std::vector<Ray>& rays, const std::vector<Vec3>& corners) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        count += hits(rays[i], corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]) ? 1 : 0;
    }
    return count;
}

template <bool (*hits)(const Ray&, const Vec3&, const Vec3&, const Vec3&)>
TriangleMethod methodOf(const std::string& name) {
    return {name, hits, countHitsBy<hits>};
}

bool hitsAny(const TriangleMethod& method, const Ray& ray, const ClosedMesh& mesh, std::span<const int> triangles) {
    return std::any_of(triangles.begin(), triangles.end(), [&](int triangle) {
        const auto [a, b, c] = mesh.corners(triangle);
        return method.hits(ray, a, b, c);
    });
}

// The triangles at the aim are tried first; a ray that misses them has leaked only if it misses all others too.
bool leaks(const TriangleMethod& method, const Ray& ray, const ClosedMesh& mesh, std::span<const int> atAim) {
    if (hitsAny(method, ray, mesh, atAim)) return false;
    std::vector<int> all(mesh.triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    return !hitsAny(method, ray, mesh, all);
}

bool edgeLeaks(const TriangleMethod& method, const ClosedMesh& mesh, Random& random) {
    const std::size_t edge = random.below(mesh.edges.size());
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(mesh.edges[edge][0])];
    const Vec3& b = mesh.vertices[static_cast<std::size_t>(mesh.edges[edge][1])];
    const Vec3 target = a + random.uniform() * (b - a);
    const Vec3 origin = mesh.pointInside(random);
    return leaks(method, {origin, target - origin}, mesh, mesh.trianglesOfEdge[edge]);
}

bool vertexLeaks(const TriangleMethod& method, const ClosedMesh& mesh, Random& random) {
    const std::size_t vertex = random.below(mesh.vertices.size());
    const Vec3 origin = mesh.pointInside(random);
    return leaks(method, {origin, mesh.vertices[vertex] - origin}, mesh, mesh.trianglesOfVertex[vertex]);
}

}  // namespace

std::vector<TriangleMethod> triangleMethods() {
    return {methodOf<hitsByCramer>("Cramer's rule"), methodOf<hitsWatertight>("watertight"),
            methodOf<hitsContracted>("watertight with fused products")};
}

FailureCount countLeaks(const TriangleMethod& method, Aim aim, std::int64_t rays, std::uint64_t seed, int threads) {
    const std::int64_t meshes = (rays + raysPerMesh - 1) / raysPerMesh;
    std::vector<FailureCount> counts(static_cast<std::size_t>(meshes));
    parallelFor(meshes, threads, [&](std::int64_t i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const ClosedMesh mesh = randomClosedMesh(random);
        FailureCount& count = counts[static_cast<std::size_t>(i)];
        count.trials = std::min(raysPerMesh, rays - i * raysPerMesh);
        for (std::int64_t ray = 0; ray < count.trials; ++ray) {
            const bool leaked = aim == Aim::Edges ? edgeLeaks(method, mesh, random) : vertexLeaks(method, mesh, random);
            if (leaked) ++count.failures;
        }
    });
    FailureCount total;
    for (const FailureCount& count : counts) total += count;
    return total;
}

}  // namespace caustic
