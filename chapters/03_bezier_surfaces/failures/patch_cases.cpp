#include "failures/patch_cases.h"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace caustic {

namespace {

constexpr Real turn = 2 * std::numbers::pi;

Vec3 onSphere(Random& random) {
    const Real z = random.uniform(-1, 1);
    const Real angle = random.uniform(0, turn);
    const Real r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

Real tiny(Random& random) { return std::pow(10, -random.uniform(0, 17)) * (random.below(2) == 0 ? 1 : -1); }

Real radiusOf(const PatchSurface& surface) { return surface.bounds().diagonal().norm() / 2; }

Vec3 around(const PatchSurface& surface, Random& random) {
    return surface.bounds().center() + 1.1 * radiusOf(surface) * onSphere(random);
}

Vec3 pointAt(const PatchSurface& surface, Real u, Real v) { return surface.patch().evaluate(u, v).point; }

Vec3 onSurface(const PatchSurface& surface, Random& random) {
    const Real u = random.uniform();
    return pointAt(surface, u, random.uniform());
}

Ray towards(const PatchSurface& surface, Random& random, const Vec3& at) {
    const Vec3 from = around(surface, random);
    return {from, at - from};
}

Ray chord(const PatchSurface& surface, Random& random) { return towards(surface, random, around(surface, random)); }

Ray atSurface(const PatchSurface& surface, Random& random) {
    return towards(surface, random, onSurface(surface, random));
}

Ray atBorder(const PatchSurface& surface, Random& random) {
    const Real along = random.uniform();
    const auto side = static_cast<Real>(random.below(2));
    return towards(surface, random,
                   random.below(2) == 0 ? pointAt(surface, side, along) : pointAt(surface, along, side));
}

Ray besideBorder(const PatchSurface& surface, Random& random) {
    Ray ray = atBorder(surface, random);
    ray.direction += 1e-9 * radiusOf(surface) * tiny(random) * onSphere(random);
    return ray;
}

Ray atCorner(const PatchSurface& surface, Random& random) {
    const auto u = static_cast<Real>(random.below(2));
    return towards(surface, random, pointAt(surface, u, static_cast<Real>(random.below(2))));
}

Ray atDyadic(const PatchSurface& surface, Random& random) {
    const Real u = static_cast<Real>(random.below(17)) / 16;
    return towards(surface, random, pointAt(surface, u, static_cast<Real>(random.below(17)) / 16));
}

Ray tangent(const PatchSurface& surface, Random& random) {
    const Real u = random.uniform();
    const SurfaceJet jet = surface.patch().evaluate(u, random.uniform());
    const Real angle = random.uniform(0, turn);
    const Vec3 normal = jet.du.cross(jet.dv).normalized();
    const Vec3 way =
        std::cos(angle) * jet.du.normalized() + std::sin(angle) * jet.dv.normalized() + tiny(random) * normal;
    if (!way.allFinite()) return chord(surface, random);
    return {jet.point - 2 * radiusOf(surface) * way, way};
}

Ray fromAfar(const PatchSurface& surface, Random& random) {
    const Vec3 from = 1e3 * around(surface, random);
    return {from, onSurface(surface, random) - from};
}

Ray fromSurface(const PatchSurface& surface, Random& random) { return {onSurface(surface, random), onSphere(random)}; }

Ray throughTwoPoints(const PatchSurface& surface, Random& random) {
    const Vec3 from = onSurface(surface, random);
    const Vec3 way = onSurface(surface, random) - from;
    if (way.norm() == 0) return chord(surface, random);
    return {from - way, way};
}

Ray alongAxis(const PatchSurface& surface, Random& random) {
    const Vec3 way = Vec3::Unit(static_cast<int>(random.below(3)));
    return {onSurface(surface, random) - 3 * radiusOf(surface) * way, way};
}

Ray nearlyAlongAxis(const PatchSurface& surface, Random& random) {
    const Vec3 way = Vec3::Unit(static_cast<int>(random.below(3))) + tiny(random) * onSphere(random);
    return {onSurface(surface, random) - 3 * radiusOf(surface) * way, way};
}

BezierPatch patchOf(int m, int n, const std::function<Vec3(Real, Real, int, int)>& point) {
    std::vector<Vec3> points;
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) points.push_back(point(Real(i) / m, Real(j) / n, i, j));
    }
    return {m, n, std::move(points)};
}

}  // namespace

std::vector<BezierPatch> difficultPatches() {
    return {
        // waves
        patchOf(3, 3, [](Real u, Real v, int i, int j) { return Vec3(u, v, (i + j) % 2 == 0 ? 0.5 : -0.5); }),
        // a saddle of degree 1
        patchOf(1, 1, [](Real u, Real v, int i, int j) { return Vec3(u, v, i == j ? 0.4 : -0.4); }),
        // one edge collapsed to a point
        patchOf(
            3, 3,
            [](Real u, Real v, int, int) { return Vec3(v * std::cos(2 * u), v * std::sin(2 * u), 0.3 - 0.3 * v * v); }),
        // folded over itself
        patchOf(3, 3,
                [](Real u, Real v, int i, int) {
                    return Vec3(i == 1 ? 1.6 : i == 2 ? -0.6 : u, v, 0.3 * u + 0.2 * v);
                }),
        // a cusp: two rows of control points coincide
        patchOf(3, 3, [](Real, Real v, int i, int) { return Vec3(i < 2 ? 0 : i - 1, v, i == 3 ? 1 : 0); }),
        // higher degrees
        patchOf(
            5, 4,
            [](Real u, Real v, int i, int j) { return Vec3(u, v + 0.1 * (i % 2), 0.8 * std::sin(3.0 * i + 2.0 * j)); }),
        patchOf(9, 9, [](Real u, Real v, int i, int j) { return Vec3(u, v, std::sin(5.0 * i) * std::cos(4.0 * j)); }),
        // nearly flat
        patchOf(3, 3, [](Real u, Real v, int i, int j) { return Vec3(u, v, 1e-9 * ((3 * i + j) % 4)); }),
    };
}

std::vector<PatchRaySet> patchRaySets() {
    return {
        {"random chords", chord},
        {"at random points", atSurface},
        {"at the border", atBorder},
        {"just beside the border", besideBorder},
        {"at corners", atCorner},
        {"at points of halving", atDyadic},
        {"tangent", tangent},
        {"from afar", fromAfar},
        {"from the surface", fromSurface},
        {"through two surface points", throughTwoPoints},
        {"along a coordinate axis", alongAxis},
        {"nearly along a coordinate axis", nearlyAlongAxis},
    };
}

}  // namespace caustic
