#include "curve/bezier_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "core/not_implemented.h"
#include "curve/bernstein.h"

namespace caustic {

namespace {

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

// Bound of the rounding error of split(t) in each coordinate: 3 operations a round, n rounds, whose weights' sizes sum
// to |1-t| + |t| each.
Real splitError(const std::vector<Vec3>& controlPoints, Real t) {
    const auto degree = static_cast<int>(controlPoints.size()) - 1;
    Real size = 0;
    for (const Vec3& point : controlPoints) size = std::max(size, point.cwiseAbs().maxCoeff());
    const Real growth = std::pow(std::abs(1 - t) + std::abs(t), degree);
    return 3 * degree * unitRoundoff * growth * size;
}

// The derivative's direction where rounding can't blur it. The steps of a split curve would do as well, but they shrink
// with 1 - t, and rounding doesn't.
std::optional<Vec3> clearDirection(const BezierCurve& curve, Real t) {
    if (!(t >= 0 && t <= 1)) return std::nullopt;
    const BezierCurve hodograph = curve.hodograph();
    Real largest = 0;
    for (const Vec3& control : hodograph.controlPoints()) largest = std::max(largest, control.cwiseAbs().maxCoeff());
    const Vec3 velocity = evaluateBernstein<Vec3>(hodograph.controlPoints(), t);
    const Real rounding = (16 * curve.degree() + 16) * unitRoundoff * largest;
    if (!(velocity.cwiseAbs().maxCoeff() > 1024 * rounding)) return std::nullopt;
    return velocity.stableNormalized();
}

}  // namespace

BezierCurve::BezierCurve(std::vector<Vec3> controlPoints) : controlPoints_(std::move(controlPoints)) {
    checkArgument(!controlPoints_.empty(), "control points", "0", "a Bézier curve needs at least one");
    for (const Vec3& point : controlPoints_) {
        for (const Real coordinate : point) checkFinite(coordinate, "control point");
    }
}

Vec3 BezierCurve::position(Real t) const {
    //! [ex-01.1]
    std::vector<Vec3> points = controlPoints_;
    for (std::size_t left = points.size(); left > 1; --left) {
        for (std::size_t i = 0; i + 1 < left; ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
    }
    return points.front();
    //! [ex-01.1]
}

Vec3 BezierCurve::derivative(Real t) const {
    //! [ex-01.2]
    if (degree() == 0) return Vec3::Zero();
    std::vector<Vec3> points = controlPoints_;
    for (std::size_t left = points.size(); left > 2; --left) {
        for (std::size_t i = 0; i + 1 < left; ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
    }
    return degree() * (points[1] - points[0]);
    //! [ex-01.2]
}

std::optional<Vec3> BezierCurve::tangent(Real t) const {
    if (std::optional<Vec3> direction = clearDirection(*this, t)) return direction;

    // B(t + s) - B(t) starts with the first of the right part's control points that differs from B(t); at the end the
    // same holds for the left part, read backwards.
    const auto [left, right] = split(t);
    const bool atEnd = t >= 1;
    std::vector<Vec3> points = atEnd ? left.controlPoints() : right.controlPoints();
    if (atEnd) std::reverse(points.begin(), points.end());

    const Real rounding = t == 0 || t == 1 ? 0 : 2 * splitError(controlPoints_, t);
    for (const Vec3& point : points) {
        const Vec3 step = point - points.front();
        if (step.cwiseAbs().maxCoeff() <= rounding) continue;
        return (atEnd ? -1 : 1) * step.stableNormalized();
    }
    return std::nullopt;
}

std::pair<BezierCurve, BezierCurve> BezierCurve::split(Real t) const {
    //! [ex-01.3]
    std::vector<Vec3> left;
    std::vector<Vec3> right = controlPoints_;
    for (std::size_t last = right.size(); last > 0; --last) {
        left.push_back(right.front());
        for (std::size_t i = 0; i + 1 < last; ++i) right[i] = (1 - t) * right[i] + t * right[i + 1];
    }
    return {BezierCurve(std::move(left)), BezierCurve(std::move(right))};
    //! [ex-01.3]
}

std::vector<std::vector<Vec3>> BezierCurve::construction(Real t) const {
    // Point i of level r is the point at t of the curve of control points i ... i + r.
    std::vector<std::vector<Vec3>> levels;
    for (auto size = std::ptrdiff_t{1}; size <= degree() + 1; ++size) {
        std::vector<Vec3> level;
        for (auto first = controlPoints_.begin(); first + size <= controlPoints_.end(); ++first) {
            level.push_back(BezierCurve(std::vector<Vec3>(first, first + size)).position(t));
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

BezierCurve BezierCurve::hodograph() const {
    if (degree() == 0) return BezierCurve({Vec3::Zero()});
    std::vector<Vec3> differences;
    for (std::size_t i = 0; i + 1 < controlPoints_.size(); ++i) {
        differences.push_back(degree() * (controlPoints_[i + 1] - controlPoints_[i]));
    }
    return BezierCurve(std::move(differences));
}

}  // namespace caustic
