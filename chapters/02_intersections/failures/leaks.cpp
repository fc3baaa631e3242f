#include "failures/leaks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "failures/closed_mesh.h"
#include "math/spawn.h"
#include "shape/cramer.h"
#include "shape/triangle.h"
#include "shape/watertight.h"

namespace caustic {

namespace {

constexpr std::int64_t raysPerMesh = 10000;

// A method: what it prepares for a ray, and how it tests a triangle with that.
struct ByCramer {
    using Prepared = Ray;
    static bool hits(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
        return intersectCramer(ray, a, b, c).has_value();
    }
};

struct Watertight {
    using Prepared = ShearedRay;
    static bool hits(const ShearedRay& sheared, const Vec3& a, const Vec3& b, const Vec3& c) {
        return intersectWatertight(sheared, a, b, c).has_value();
    }
};

// p − r·s and p·q − r·s, each operation rounded.
struct Rounded {
    static Real difference(Real p, Real r, Real s) { return p - r * s; }
    static Real differenceOfProducts(Real p, Real q, Real r, Real s) { return p * q - r * s; }
};

// What -ffp-contract=fast makes of them. p·q − r·s is no longer the negative of r·s − p·q, and the two triangles at an
// edge may both call it outside.
struct Fused {
    static Real difference(Real p, Real r, Real s) { return std::fma(-r, s, p); }
    static Real differenceOfProducts(Real p, Real q, Real r, Real s) { return std::fma(p, q, -(r * s)); }
};

// The paper's lines, in double to begin with, so that there is nothing to fall back to where products are equal; and t
// as it comes.
template <typename Arithmetic>
struct WatertightAsPublished {
    using Prepared = ShearedRay;
    static Vec3 shearedVertex(const ShearedRay& sheared, const Vec3& vertex) {
        const auto [x, y, z] = sheared.axis;
        const Vec3 from = vertex - sheared.ray.origin;
        return {Arithmetic::difference(from[x], sheared.shear.x(), from[z]),
                Arithmetic::difference(from[y], sheared.shear.y(), from[z]), from[z]};
    }

    // A call, as the library's tests are, or the chart would compare what inlining saves.
    [[gnu::noinline]] static bool hits(const ShearedRay& sheared, const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 p = shearedVertex(sheared, a);
        const Vec3 q = shearedVertex(sheared, b);
        const Vec3 r = shearedVertex(sheared, c);
        const Real u = Arithmetic::differenceOfProducts(r.x(), q.y(), r.y(), q.x());
        const Real v = Arithmetic::differenceOfProducts(p.x(), r.y(), p.y(), r.x());
        const Real w = Arithmetic::differenceOfProducts(q.x(), p.y(), q.y(), p.x());
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
        const Real determinant = u + v + w;
        if (determinant == 0) return false;
        return sheared.ray.reaches(sheared.shear.z() * (u * p.z() + v * q.z() + w * r.z()) / determinant);
    }
};

template <typename Method>
bool hitsBy(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    return Method::hits(typename Method::Prepared(ray), a, b, c);
}

template <typename Method>
std::int64_t countHitsBy(const std::vector<Ray>& rays, const std::vector<Vec3>& corners) {
    std::int64_t count = 0;
    for (const Ray& ray : rays) {
        // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): of one method it is the ray itself.
        const typename Method::Prepared prepared(ray);
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            count += Method::hits(prepared, corners[i], corners[i + 1], corners[i + 2]) ? 1 : 0;
        }
    }
    return count;
}

template <typename Method>
TriangleMethod methodOf(const std::string& name, bool robust = false) {
    return {name, robust, hitsBy<Method>, countHitsBy<Method>};
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
    return {methodOf<ByCramer>("Cramer's rule"), methodOf<Watertight>("watertight", true),
            methodOf<WatertightAsPublished<Rounded>>("watertight as published"),
            methodOf<WatertightAsPublished<Fused>>("watertight with fused products")};
}

FailureCount countLeaks(const TriangleMethod& method, Aim aim, std::int64_t rays, std::uint64_t seed, int threads,
                        std::optional<Real> away) {
    const std::int64_t meshes = (rays + raysPerMesh - 1) / raysPerMesh;
    std::vector<FailureCount> counts(static_cast<std::size_t>(meshes));
    parallelFor(meshes, threads, [&](std::int64_t i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const ClosedMesh mesh = randomClosedMesh(random, away);
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

FailureCount countSliverSelfHits(const TriangleMethod& method, Real width, std::int64_t rays, std::uint64_t seed) {
    FailureCount count;
    for (; count.trials < rays; ++count.trials) {
        Random random(seed, {static_cast<std::uint64_t>(count.trials)});
        const Vec3 end = randomDirection(random);
        const Vec3 apex = random.uniform(-0.9, 0.9) * end + width * end.unitOrthogonal();
        const Triangle sliver(end, -end, apex);
        const SurfacePoint at = sliver.sampleArea({random.uniform(), random.uniform()})->at;
        const Ray away = spawnRay(at, directionBeside(at.ng, true, random));
        count.failures += method.hits(away, end, -end, apex) ? 1 : 0;
    }
    return count;
}

}  // namespace caustic
