#include "curve/bezier_curve.h"

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

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

}  // namespace caustic
