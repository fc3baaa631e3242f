#pragma once

#include <vector>

#include "math/vector.h"

namespace caustic {

/// A Bézier curve of any degree in space: B(t) = sum of C(n,i) (1-t)^(n-i) t^i P_i.
class BezierCurve {
public:
    /// @param controlPoints  n + 1 finite points for degree n; at least one
    /// @throws InputError when there is none, or a coordinate is not finite
    explicit BezierCurve(std::vector<Vec3> controlPoints);

    int degree() const { return static_cast<int>(controlPoints_.size()) - 1; }
    const std::vector<Vec3>& controlPoints() const { return controlPoints_; }

    /// The point at t by de Casteljau's algorithm. Any finite t; outside [0, 1] the polynomial goes on.
    Vec3 position(Real t) const;

private:
    std::vector<Vec3> controlPoints_;
};

}  // namespace caustic
