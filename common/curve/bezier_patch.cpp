#include "curve/bezier_patch.h"

#include <string>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

// One round of interpolation less than de Casteljau's triangle has: the last two points.
std::pair<Vec3, Vec3> lastPair(std::vector<Vec3> points, Real t) {
    for (std::size_t left = points.size(); left > 2; --left) {
        for (std::size_t i = 0; i + 1 < left; ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
    }
    return {points[0], points[1]};
}

Vec3 between(const std::pair<Vec3, Vec3>& pair, Real t) { return (1 - t) * pair.first + t * pair.second; }

}  // namespace

BezierPatch::BezierPatch(int degreeU, int degreeV, std::vector<Vec3> points)
    : degreeU_(degreeU), degreeV_(degreeV), points_(std::move(points)) {
    checkArgument(degreeU >= 1 && degreeV >= 1, "patch's degrees",
                  std::to_string(degreeU) + " and " + std::to_string(degreeV), "must be at least 1");
    const std::size_t expected = static_cast<std::size_t>(degreeU + 1) * static_cast<std::size_t>(degreeV + 1);
    checkArgument(points_.size() == expected, "patch's control points", std::to_string(points_.size()),
                  "must be " + std::to_string(expected));
    for (const Vec3& point : points_) {
        for (const Real coordinate : point) checkFinite(coordinate, "patch's control point");
    }
}

SurfaceJet BezierPatch::evaluate(Real u, Real v) const {
    //! [ex-03.1]
    const auto rowLength = static_cast<std::ptrdiff_t>(degreeV_ + 1);
    std::vector<Vec3> points;
    std::vector<Vec3> slopes;
    for (auto row = points_.begin(); row != points_.end(); row += rowLength) {
        const auto pair = lastPair({row, row + rowLength}, v);
        points.push_back(between(pair, v));
        slopes.push_back(degreeV_ * (pair.second - pair.first));
    }
    const auto pair = lastPair(points, u);
    return {between(pair, u), degreeU_ * (pair.second - pair.first), between(lastPair(slopes, u), u)};
    //! [ex-03.1]
}

std::pair<BezierPatch, BezierPatch> BezierPatch::splitV(Real t) const {
    //! [ex-03.2]
    std::vector<Vec3> left;
    std::vector<Vec3> right = points_;
    const auto rowLength = static_cast<std::size_t>(degreeV_ + 1);
    for (std::size_t row = 0; row < right.size(); row += rowLength) {
        for (std::size_t count = rowLength; count > 0; --count) {
            left.push_back(right[row]);
            for (std::size_t i = row; i + 1 < row + count; ++i) right[i] = (1 - t) * right[i] + t * right[i + 1];
        }
    }
    return {BezierPatch(degreeU_, degreeV_, std::move(left)), BezierPatch(degreeU_, degreeV_, std::move(right))};
    //! [ex-03.2]
}

Bounds3 BezierPatch::bounds() const {
    Bounds3 box;
    for (const Vec3& point : points_) box.extend(point);
    return box;
}

}  // namespace caustic
