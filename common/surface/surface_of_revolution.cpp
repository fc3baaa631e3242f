#include "surface/surface_of_revolution.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/check.h"
#include "core/not_implemented.h"
#include "curve/curve_bounds.h"
#include "curve/gauss_legendre.h"
#include "math/slabs.h"

namespace caustic {

namespace {

constexpr Real turn = 2 * std::numbers::pi;
constexpr int cellsPerSegment = 64;

BezierCurve reversed(const BezierCurve& curve) {
    return BezierCurve({curve.controlPoints().rbegin(), curve.controlPoints().rend()});
}

// π ∫ x² dy: the volume on the left of the profile's way, when the surface is closed. Exact for the rule's degree.
Real volumeOf(const BezierCurve& curve) {
    Real sum = 0;
    const GaussRule rule = gaussLegendreRule((3 * curve.degree()) / 2 + 1);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const Real u = (1 + rule.nodes[i]) / 2;
        const Real x = curve.position(u).x();
        sum += rule.weights[i] / 2 * x * x * curve.derivative(u).y();
    }
    return std::numbers::pi * sum;
}

std::vector<BezierCurve> outwards(std::vector<BezierCurve> profile) {
    checkArgument(!profile.empty(), "profile", "no segment", "a surface of revolution needs at least one");
    Real volume = 0;
    for (const BezierCurve& segment : profile) volume += volumeOf(segment);
    if (volume >= 0) return profile;
    std::vector<BezierCurve> turned;
    for (auto segment = profile.rbegin(); segment != profile.rend(); ++segment) turned.push_back(reversed(*segment));
    return turned;
}

Bounds3 boundsOf(const std::vector<BezierCurve>& profile) {
    Bounds3 flat;
    for (const BezierCurve& segment : profile) flat.extend(exactBounds(segment));
    // The hit's point is rounded once more when it is turned to its angle.
    const Real largest = std::max(std::abs(flat.min().x()), std::abs(flat.max().x()));
    const Real radius = largest * (1 + 8 * std::numeric_limits<Real>::epsilon());
    return {Vec3(-radius, flat.min().y(), -radius), Vec3(radius, flat.max().y(), radius)};
}

Real cellArea(const BezierCurve& segment, int cell) {
    const Real u = (cell + Real(0.5)) / cellsPerSegment;
    return std::abs(segment.position(u).x()) * segment.derivative(u).head<2>().norm();
}

DiscreteDistribution cellsOf(const std::vector<BezierCurve>& profile) {
    std::vector<Real> areas;
    for (const BezierCurve& segment : profile) {
        for (int cell = 0; cell < cellsPerSegment; ++cell) areas.push_back(cellArea(segment, cell));
    }
    return DiscreteDistribution(areas);
}

}  // namespace

SurfaceOfRevolution::SurfaceOfRevolution(std::vector<BezierCurve> profile)
    : profile_(outwards(std::move(profile))),
      segments_(profile_.begin(), profile_.end()),
      bounds_(boundsOf(profile_)),
      middle_(bounds_.min().y() / 2 + bounds_.max().y() / 2),
      rises_(profile_.back().controlPoints().back().y() > profile_.front().controlPoints().front().y()),
      magnitude_(bounds_.min().cwiseAbs().cwiseMax(bounds_.max().cwiseAbs()).maxCoeff()),
      cells_(cellsOf(profile_)) {}

SurfaceOfRevolution::Place SurfaceOfRevolution::placeAt(Real u) const {
    const Real along = std::clamp(u, Real(0), Real(1)) * static_cast<Real>(profile_.size());
    const std::size_t segment = std::min(static_cast<std::size_t>(along), profile_.size() - 1);
    return {segment, along - static_cast<Real>(segment)};
}

SurfaceJet SurfaceOfRevolution::evaluate(Real u, Real v) const { return jetAt(placeAt(u), v); }

Vec3 SurfaceOfRevolution::normal(Real u, Real v) const {
    const Place place = placeAt(u);
    const RevolvedSegment::ProfilePoint profile = segments_[place.segment].profileAt(place.u);
    const Real sign = profile.position.x() < 0 ? -1 : 1;
    return normalAt(place, profile, sign * Vec2(std::cos(turn * v), std::sin(turn * v)));
}

SurfaceJet SurfaceOfRevolution::jetAt(const Place& place, Real v) const {
    //! [ex-03.3]
    const Vec3 position = profile_[place.segment].position(place.u);
    const Vec3 derivative = profile_[place.segment].derivative(place.u) * static_cast<Real>(profile_.size());
    const Real c = std::cos(turn * v);
    const Real s = std::sin(turn * v);
    return {{position.x() * c, position.y(), position.x() * s},
            {derivative.x() * c, derivative.y(), derivative.x() * s},
            {-turn * position.x() * s, 0, turn * position.x() * c}};
    //! [ex-03.3]
}

// outward: unit vector in x and z from the axis to the point.
Vec3 SurfaceOfRevolution::normalAt(const Place& place, const RevolvedSegment::ProfilePoint& profile,
                                   const Vec2& outward) const {
    const Real x = profile.position.x();
    Vec2 way = profile.derivative;
    // Below this the derivative is rounding: a cusp, or coincident control points.
    if (way.norm() <= 64 * std::numeric_limits<Real>::epsilon() * magnitude_) {
        way = profile_[place.segment].tangent(place.u).value_or(Vec3::UnitY()).head<2>();
    }
    way.normalize();
    // A profile that has crossed the axis has its outside on its left.
    const Real sign = x < 0 || (x == 0 && way.x() < 0 && place.u < 1) ? -1 : 1;
    if (std::abs(x) <= std::numeric_limits<Real>::epsilon() * magnitude_ && way.x() != 0) {
        return {0, std::copysign(Real(1), -sign * way.x()), 0};
    }
    return {way.y() * outward.x(), -sign * way.x(), way.y() * outward.y()};
}

bool SurfaceOfRevolution::canMeet(const Ray& ray) const { return mayMeet(bounds_, ray); }

Hit SurfaceOfRevolution::hitAt(const Ray& ray, const Place& place, Real t) const {
    const Vec3 near = ray.at(t);
    const RevolvedSegment::ProfilePoint profile = segments_[place.segment].profileAt(place.u);
    const auto& [position, derivative] = profile;
    const Real sign = position.x() < 0 ? -1 : 1;
    const Real distance = std::hypot(near.x(), near.z());
    const Vec2 outward = distance > 0 ? Vec2(near.x() / distance, near.z() / distance) : Vec2(Vec2::UnitX());
    const Real v = std::atan2(sign * outward.y(), sign * outward.x()) / turn;

    Hit hit;
    const Real radius = std::abs(position.x());
    hit.point = {radius * outward.x(), position.y(), radius * outward.y()};
    hit.ng = normalAt(place, profile, outward);
    hit.ns = hit.ng;
    hit.uv = {(static_cast<Real>(place.segment) + place.u) / static_cast<Real>(profile_.size()), v < 0 ? v + 1 : v};
    hit.magnitude = magnitude_;
    hit.t = t;
    // As jetAt, but the ray's point has the cosine and the sine already.
    const Vec2 way = derivative * static_cast<Real>(profile_.size());
    hit.dpdu = {sign * way.x() * outward.x(), way.y(), sign * way.x() * outward.y()};
    hit.dpdv = turn * radius * Vec3(-outward.y(), 0, outward.x());
    return hit;
}

std::optional<Hit> SurfaceOfRevolution::intersect(const Ray& ray) const {
    if (!canMeet(ray)) return std::nullopt;
    const AxisRay axisRay(ray, middle_);
    Place nearest = {0, 0};
    Real tNearest = ray.tMax;
    bool found = false;
    const bool againstTheProfile = (axisRay.rise < 0) == rises_;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
        const std::size_t i = againstTheProfile ? segments_.size() - 1 - k : k;
        const auto reach = segments_[i].reach(axisRay);
        if (!reach || axisRay.tAt(reach->from) > tNearest || axisRay.tAt(reach->to) < ray.tMin) continue;
        for (const RevolvedRoot& root : segments_[i].roots(axisRay)) {
            const Real t = axisRay.tAt(root.distance);
            if (!(t > ray.tMin && t < tNearest)) continue;
            tNearest = t;
            nearest = {i, root.u};
            found = true;
        }
    }
    if (!found) return std::nullopt;
    return hitAt(ray, nearest, tNearest);
}

bool SurfaceOfRevolution::occluded(const Ray& ray) const {
    if (!canMeet(ray)) return false;
    const AxisRay axisRay(ray, middle_);
    for (const RevolvedSegment& segment : segments_) {
        if (!segment.reach(axisRay)) continue;
        for (const RevolvedRoot& root : segment.roots(axisRay)) {
            if (ray.reaches(axisRay.tAt(root.distance))) return true;
        }
    }
    return false;
}

std::optional<AreaSample> SurfaceOfRevolution::sampleArea(const Vec2& u) const {
    const auto [cell, rest] = cells_.choose(u.x());
    const Place place = {cell / cellsPerSegment, (static_cast<Real>(cell % cellsPerSegment) + rest) / cellsPerSegment};
    const SurfaceJet jet = jetAt(place, u.y());
    SurfacePoint at;
    at.point = jet.point;
    const RevolvedSegment::ProfilePoint profile = segments_[place.segment].profileAt(place.u);
    const Real sign = profile.position.x() < 0 ? -1 : 1;
    at.ng = normalAt(place, profile, sign * Vec2(std::cos(turn * u.y()), std::sin(turn * u.y())));
    at.uv = {(static_cast<Real>(place.segment) + place.u) / static_cast<Real>(profile_.size()), u.y()};
    at.magnitude = magnitude_;
    const Real pdf = pdfA(at);
    if (!std::isfinite(pdf)) return std::nullopt;  // on the axis: chosen with probability 0
    return AreaSample{at, pdf};
}

Real SurfaceOfRevolution::pdfA(const SurfacePoint& at) const {
    const Place place = placeAt(at.uv.x());
    const int cell = std::min(static_cast<int>(place.u * cellsPerSegment), cellsPerSegment - 1);
    const SurfaceJet jet = jetAt(place, at.uv.y());
    const Real probability = cells_.probability(place.segment * cellsPerSegment + static_cast<std::size_t>(cell));
    return probability * cellsPerSegment * static_cast<Real>(profile_.size()) / jet.du.cross(jet.dv).norm();
}

}  // namespace caustic
