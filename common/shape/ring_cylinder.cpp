#include "shape/ring_cylinder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/check.h"
#include "core/not_implemented.h"
#include "shape/ball.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

Vec2 horizontal(const Vec3& v) { return {v.x(), v.z()}; }

// Where the ray's line is within a cylinder around y.
Interval cylinderInterval(const Ray& ray, Real radius) {
    return ballInterval<Real, 2>(-horizontal(ray.origin), horizontal(ray.direction), radius);
}

}  // namespace

RingCylinder::RingCylinder(Real innerRadius, Real outerRadius, Real bottom, Real top)
    : innerRadius_(innerRadius), outerRadius_(outerRadius), bottom_(bottom), top_(top) {
    checkFinite(innerRadius, "ring cylinder's inner radius");
    checkArgument(innerRadius >= 0, "ring cylinder's inner radius", formatReal(innerRadius), "must not be negative");
    checkPositive(outerRadius - innerRadius, "ring cylinder's outer minus inner radius");
    checkFinite(bottom, "ring cylinder's bottom");
    checkPositive(top - bottom, "ring cylinder's height");
    magnitude_ = std::max({outerRadius, std::abs(bottom), std::abs(top)});
}

// The cylinder without its hole, between the planes of bottom and top.
std::optional<RingCylinder::Span> RingCylinder::convexSpan(const Ray& ray) const {
    const Interval wall = cylinderInterval(ray, outerRadius_);
    if (wall.empty()) return std::nullopt;
    Span span = {{wall.lower, Part::OuterWall}, {wall.upper, Part::OuterWall}};
    const Real y = ray.origin.y();
    if (ray.direction.y() == 0) {
        if (!(y >= bottom_ && y <= top_)) return std::nullopt;
        return span;
    }
    Crossing first = {(bottom_ - y) / ray.direction.y(), Part::Bottom};
    Crossing second = {(top_ - y) / ray.direction.y(), Part::Top};
    if (first.t > second.t) std::swap(first, second);
    if (!(first.t <= second.t)) return std::nullopt;  // NaN in the ray
    if (first.t > span.enter.t) span.enter = first;
    if (second.t < span.leave.t) span.leave = second;
    if (!(span.enter.t <= span.leave.t)) return std::nullopt;
    return span;
}

RingCylinder::Spans RingCylinder::spans(const Ray& ray) const {
    //! [ex-02.5]
    const std::optional<Span> solid = convexSpan(ray);
    if (!solid) return {};
    const Interval hole = innerRadius_ > 0 ? cylinderInterval(ray, innerRadius_) : Interval{1, 0};
    if (hole.empty()) return {{{*solid}}, 1};

    Spans spans;
    const auto [enter, leave] = *solid;
    if (enter.t < hole.lower) {
        const Crossing intoHole = {hole.lower, Part::InnerWall};
        spans.span[spans.count++] = {enter, leave.t < hole.lower ? leave : intoHole};
    }
    if (leave.t > hole.upper) {
        const Crossing outOfHole = {hole.upper, Part::InnerWall};
        spans.span[spans.count++] = {enter.t > hole.upper ? enter : outOfHole, leave};
    }
    return spans;
    //! [ex-02.5]
}

std::optional<Hit> RingCylinder::intersect(const Ray& ray) const {
    const std::optional<Crossing> crossing = nearest(ray);
    if (!crossing) return std::nullopt;

    Hit hit;
    static_cast<SurfacePoint&>(hit) = surfacePoint(crossing->part, ray.at(crossing->t));
    hit.t = crossing->t;
    hit.ns = hit.ng;
    hit.dpdu = 2 * pi * Vec3(hit.point.z(), 0, -hit.point.x());
    // Along the cross-section: the outward normal, turned by a right angle in the plane through the axis.
    const Real radius = horizontal(hit.point).norm();
    const Vec3 outward = radius > 0 ? Vec3(hit.point.x() / radius, 0, hit.point.z() / radius) : Vec3(Vec3::UnitX());
    hit.dpdv = perimeter() * (hit.ng.dot(outward) * Vec3::UnitY() - hit.ng.y() * outward);
    return hit;
}

bool RingCylinder::occluded(const Ray& ray) const { return nearest(ray).has_value(); }

Bounds3 RingCylinder::bounds() const {
    return {Vec3(-outerRadius_, bottom_, -outerRadius_), Vec3(outerRadius_, top_, outerRadius_)};
}

std::optional<AreaSample> RingCylinder::sampleArea(const Vec2& u) const {
    // u.y chooses a part by area; what is left of it is uniform within the part.
    Real rest = u.y() * 2 * (area(Part::Bottom) + (area(Part::OuterWall) + area(Part::InnerWall)) / 2);
    Part part = Part::Bottom;
    for (const Part next : {Part::OuterWall, Part::Top, Part::InnerWall}) {
        if (rest < area(part) || area(next) == 0) break;
        rest -= area(part);
        part = next;
    }
    const Real share = std::min(rest / area(part), Real(1));
    const bool wall = part == Part::OuterWall || part == Part::InnerWall;
    // Equal areas of a disc between equal steps of r².
    const Real inner = innerRadius_ * innerRadius_;
    const Real radius = wall ? outerRadius_ : std::sqrt(inner + share * (outerRadius_ * outerRadius_ - inner));
    const Real angle = 2 * pi * u.x();
    const Real y = bottom_ + share * height();
    const SurfacePoint at = surfacePoint(part, {radius * std::cos(angle), y, -radius * std::sin(angle)});
    return AreaSample{at, pdfA(at)};
}

Real RingCylinder::pdfA(const SurfacePoint&) const {
    return 1 / (2 * area(Part::Bottom) + area(Part::OuterWall) + area(Part::InnerWall));
}

std::optional<RingCylinder::Crossing> RingCylinder::nearest(const Ray& ray) const {
    for (const Span& span : spans(ray)) {
        if (ray.reaches(span.enter.t)) return span.enter;
        if (ray.reaches(span.leave.t)) return span.leave;
    }
    return std::nullopt;
}

// The point of that part closest to `near`, which is there but for rounding.
SurfacePoint RingCylinder::surfacePoint(Part part, const Vec3& near) const {
    const Real distance = horizontal(near).norm();
    const Vec3 outward = distance > 0 ? Vec3(near.x() / distance, 0, near.z() / distance) : Vec3(Vec3::UnitX());
    const Real angle = std::atan2(-outward.z(), outward.x());
    const Real u = angle < 0 ? angle / (2 * pi) + 1 : angle / (2 * pi);
    const Real y = std::clamp(near.y(), bottom_, top_);
    const Real radius = std::clamp(distance, innerRadius_, outerRadius_);
    const auto at = [&](Real r, Real height, const Vec3& normal, Real length) {
        const Vec3 point(r * outward.x(), height, r * outward.z());
        return SurfacePoint{point, normal, {u, length / perimeter()}, magnitude_};
    };
    switch (part) {
        case Part::Bottom:
            return at(radius, bottom_, -Vec3::UnitY(), radius - innerRadius_);
        case Part::OuterWall:
            return at(outerRadius_, y, outward, width() + y - bottom_);
        case Part::Top:
            return at(radius, top_, Vec3::UnitY(), width() + height() + outerRadius_ - radius);
        default:
            return at(innerRadius_, y, -outward, 2 * width() + height() + top_ - y);
    }
}

Real RingCylinder::area(Part part) const {
    switch (part) {
        case Part::OuterWall:
            return 2 * pi * outerRadius_ * height();
        case Part::InnerWall:
            return 2 * pi * innerRadius_ * height();
        default:
            return pi * (outerRadius_ * outerRadius_ - innerRadius_ * innerRadius_);
    }
}

}  // namespace caustic
