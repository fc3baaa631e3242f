#include "surface/patch_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/check.h"
#include "math/slabs.h"

namespace caustic {

namespace {

constexpr int cellsAlong = 16;

BezierPatch checked(BezierPatch patch) {
    checkArgument(std::max(patch.degreeU(), patch.degreeV()) <= PlaneNet::highestDegree, "patch's degrees",
                  std::to_string(patch.degreeU()) + " and " + std::to_string(patch.degreeV()),
                  "must be at most " + std::to_string(PlaneNet::highestDegree));
    return patch;
}

DiscreteDistribution cellsOf(const BezierPatch& patch) {
    std::vector<Real> areas;
    for (int i = 0; i < cellsAlong; ++i) {
        for (int j = 0; j < cellsAlong; ++j) {
            const SurfaceJet jet = patch.evaluate((i + Real(0.5)) / cellsAlong, (j + Real(0.5)) / cellsAlong);
            areas.push_back(jet.du.cross(jet.dv).norm());
        }
    }
    return DiscreteDistribution(areas);
}

// The control points' box, a little larger: points are computed with rounding, and roots found within a tolerance.
Bounds3 paddedBounds(const BezierPatch& patch, Real magnitude) {
    const Vec3 pad = Vec3::Constant(128 * std::numeric_limits<Real>::epsilon() * magnitude);
    const Bounds3 box = patch.bounds();
    return {box.min() - pad, box.max() + pad};
}

Real largestCoordinateOf(const BezierPatch& patch) {
    const Bounds3 box = patch.bounds();
    return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

}  // namespace

PatchSurface::PatchSurface(BezierPatch patch)
    : patch_(checked(std::move(patch))), magnitude_(largestCoordinateOf(patch_)), cells_(cellsOf(patch_)) {
    bounds_ = paddedBounds(patch_, magnitude_);
}

Vec3 PatchSurface::normal(Real u, Real v) const {
    SurfaceJet jet = patch_.evaluate(u, v);
    Vec3 normal = jet.du.cross(jet.dv);
    constexpr Real singular = 1e-10;
    if (normal.norm() > singular * jet.du.norm() * jet.dv.norm() &&
        normal.norm() > singular * magnitude_ * magnitude_) {
        return normal.normalized();
    }
    constexpr Real inwards = 1e-6;
    jet = patch_.evaluate(u + inwards * (Real(0.5) - u), v + inwards * (Real(0.5) - v));
    normal = jet.du.cross(jet.dv);
    return normal.norm() > 0 ? normal.normalized().eval() : Vec3::UnitZ();
}

std::vector<PatchRoot> PatchSurface::rootsAlong(const Ray& ray) const {
    if (!mayMeet(bounds_, ray)) return {};
    return patchRoots(patch_, ShearedRay(ray));
}

std::optional<Hit> PatchSurface::intersect(const Ray& ray) const {
    std::optional<PatchRoot> nearest;
    for (const PatchRoot& root : rootsAlong(ray)) {
        if (ray.reaches(root.t) && !(nearest && nearest->t <= root.t)) nearest = root;
    }
    if (!nearest) return std::nullopt;

    const SurfaceJet jet = patch_.evaluate(nearest->u, nearest->v);
    Hit hit;
    hit.point = jet.point;
    hit.ng = normal(nearest->u, nearest->v);
    hit.ns = hit.ng;
    hit.uv = {nearest->u, nearest->v};
    hit.magnitude = magnitude_;
    hit.t = nearest->t;
    hit.dpdu = jet.du;
    hit.dpdv = jet.dv;
    return hit;
}

bool PatchSurface::occluded(const Ray& ray) const {
    const std::vector<PatchRoot> roots = rootsAlong(ray);
    return std::any_of(roots.begin(), roots.end(), [&](const PatchRoot& root) { return ray.reaches(root.t); });
}

std::optional<AreaSample> PatchSurface::sampleArea(const Vec2& u) const {
    const auto [cell, rest] = cells_.choose(u.x());
    const Vec2 uv =
        Vec2(static_cast<Real>(cell / cellsAlong) + rest, static_cast<Real>(cell % cellsAlong) + u.y()) / cellsAlong;
    const SurfacePoint at = {patch_.evaluate(uv.x(), uv.y()).point, normal(uv.x(), uv.y()), uv, magnitude_};
    const Real pdf = pdfA(at);
    if (!std::isfinite(pdf)) return std::nullopt;  // on a collapsed edge: chosen with probability 0
    return AreaSample{at, pdf};
}

Real PatchSurface::pdfA(const SurfacePoint& at) const {
    const auto cellOf = [](Real u) { return std::min(static_cast<int>(u * cellsAlong), cellsAlong - 1); };
    const auto cell = static_cast<std::size_t>(cellOf(at.uv.x()) * cellsAlong + cellOf(at.uv.y()));
    const SurfaceJet jet = patch_.evaluate(at.uv.x(), at.uv.y());
    return cells_.probability(cell) * cellsAlong * cellsAlong / jet.du.cross(jet.dv).norm();
}

}  // namespace caustic
