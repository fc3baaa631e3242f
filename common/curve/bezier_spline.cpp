#include "curve/bezier_spline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "curve/curve_bounds.h"
#include "curve/profile_limits.h"

namespace caustic {

namespace {

constexpr int cubic = 3;

// One degree higher, the same curve: P'_i = i/(n+1) P_(i-1) + (1 - i/(n+1)) P_i.
std::vector<Vec3> raised(const std::vector<Vec3>& points) {
    const std::size_t n = points.size();
    std::vector<Vec3> higher = {points.front()};
    for (std::size_t i = 1; i < n; ++i) {
        const Real share = static_cast<Real>(i) / static_cast<Real>(n);
        higher.emplace_back(share * points[i - 1] + (1 - share) * points[i]);
    }
    higher.push_back(points.back());
    return higher;
}

BezierCurve asCubic(BezierCurve curve) {
    if (curve.degree() == cubic) return curve;
    checkArgument(curve.degree() < cubic, "segment of a spline", "degree " + std::to_string(curve.degree()),
                  "must be of degree 3 or lower");
    std::vector<Vec3> points = curve.controlPoints();
    while (points.size() <= cubic) points = raised(points);
    return BezierCurve(std::move(points));
}

// By atan2, which keeps small angles that the arc cosine loses.
Real angleBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Joint jointBetween(const BezierCurve& before, const BezierCurve& after, Real size, const JointTolerance& tolerance) {
    const Vec3 in = before.derivative(1);
    const Vec3 out = after.derivative(0);
    Joint joint{Continuity::Gap, (after.controlPoints().front() - before.controlPoints().back()).norm(), std::nullopt,
                (out - in).norm()};
    const auto tangentIn = before.tangent(1);
    const auto tangentOut = after.tangent(0);
    if (tangentIn && tangentOut) joint.angle = angleBetween(*tangentIn, *tangentOut);

    if (joint.distance > tolerance.distance * size) return joint;
    joint.continuity = Continuity::C0;
    if (!joint.angle || *joint.angle > tolerance.angle) return joint;
    joint.continuity = Continuity::G1;
    if (joint.derivativeDifference > tolerance.derivative * std::max(in.norm(), out.norm())) return joint;
    joint.continuity = Continuity::C1;
    return joint;
}

}  // namespace

const char* name(Continuity continuity) {
    switch (continuity) {
        case Continuity::Gap:
            return "gap";
        case Continuity::C0:
            return "C0";
        case Continuity::G1:
            return "G1";
        case Continuity::C1:
            break;
    }
    return "C1";
}

BezierSpline::BezierSpline(std::vector<BezierCurve> segments, bool closed) : closed_(closed) {
    checkArgument(!segments.empty(), "segments", "0", "a spline needs at least one");
    segments_.reserve(segments.size());
    for (BezierCurve& segment : segments) {
        for (const Vec3& point : segment.controlPoints()) {
            const Real largest = point.cwiseAbs().maxCoeff();
            if (largest > largestCoordinate)
                throw InputError({"control point", 0}, formatReal(largest),
                                 "must not be larger than " + formatReal(largestCoordinate));
        }
        segments_.push_back(asCubic(std::move(segment)));
    }
}

BezierSpline BezierSpline::fromControlPoints(const std::vector<Vec3>& points, bool closed) {
    checkArgument(points.size() >= 4 && points.size() % cubic == 1, "control points", std::to_string(points.size()),
                  "a spline of n cubic segments needs 3n + 1: 4, 7, 10, ...");
    std::vector<BezierCurve> segments;
    segments.reserve(points.size() / cubic);
    for (auto first = points.begin(); first + cubic < points.end(); first += cubic) {
        segments.emplace_back(std::vector<Vec3>(first, first + cubic + 1));
    }
    return BezierSpline(std::move(segments), closed);
}

std::optional<std::vector<Vec3>> BezierSpline::controlPoints() const {
    std::vector<Vec3> points = {segments_.front().controlPoints().front()};
    for (const BezierCurve& segment : segments_) {
        const std::vector<Vec3>& own = segment.controlPoints();
        if (own.front() != points.back()) return std::nullopt;
        points.insert(points.end(), own.begin() + 1, own.end());
    }
    return points;
}

Vec3 BezierSpline::position(Real u) const {
    const Real last = static_cast<Real>(segments_.size() - 1);
    const Real first = std::clamp(std::floor(u), Real(0), last);
    return segments_[static_cast<std::size_t>(first)].position(u - first);
}

std::vector<Joint> BezierSpline::joints(const JointTolerance& tolerance) const {
    Bounds3 box;
    for (const BezierCurve& segment : segments_) {
        for (const Vec3& point : segment.controlPoints()) box.extend(point);
    }
    const Real size = box.diagonal().norm();

    std::vector<Joint> joints;
    const std::size_t count = closed_ ? segments_.size() : segments_.size() - 1;
    joints.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        joints.push_back(jointBetween(segments_[i], segments_[(i + 1) % segments_.size()], size, tolerance));
    }
    return joints;
}

LengthEstimate BezierSpline::length(Real tolerance) const {
    checkPositive(tolerance, "tolerance");
    const auto count = static_cast<Real>(segments_.size());
    const Real share = std::max(tolerance / count, std::numeric_limits<Real>::denorm_min());
    LengthEstimate total{0, 0, 0};
    for (const BezierCurve& segment : segments_) {
        const LengthEstimate own = gaussLength(segment, share);
        total.length += own.length;
        total.error += own.error;
        total.evaluations += own.evaluations;
    }
    total.error += count * std::numeric_limits<Real>::epsilon() * total.length;  // of adding them up
    return total;
}

Bounds3 BezierSpline::bounds() const {
    Bounds3 box;
    for (const BezierCurve& segment : segments_) box.extend(exactBounds(segment));
    return box;
}

}  // namespace caustic
