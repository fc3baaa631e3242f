#pragma once

#include <vector>

#include "curve/bezier_curve.h"
#include "surface/newton.h"

namespace caustic {

/// One Bézier curve turned around the y axis, as the report's Newton method sees it: B = (x cos 2πv, y, x sin 2πv).
class RevolvedCurve final : public ParametricSurface {
public:
    /// @param profile  of degree 1 or higher
    /// @param samples  pieces into which u is cut for bracketing starts, at least 1
    /// @throws InputError for other numbers
    RevolvedCurve(const BezierCurve& profile, int samples);

    SurfaceJet evaluate(Real u, Real v) const override;
    bool closedInV() const override { return true; }

    /// The report's fourth remedy: starts just before and behind each meeting that samples betray. Each sample's circle
    /// lies in a plane of rotation; where the ray crosses that plane it is inside the circle or outside. Between two
    /// samples of which one has it inside and the other outside, the ray must meet the surface. Two meetings between
    /// the same two samples go unseen, and a ray within a plane of rotation crosses none.
    /// @return for each such pair of neighbours a start at both, in the order of u: the sample's u, the t at which
    ///         the ray's line crosses its plane, of either sign, and as v the angle of that point, in turns, any
    ///         multiple of a turn apart; on a negative radius the point is at the opposite angle. On the circle
    ///         counts as outside.
    NewtonStarts bracketingStarts(const Ray& ray) const;

private:
    struct Sample {
        Real u;
        Real radius;  // x of the profile, negative beyond the axis
        Real height;
    };

    std::vector<Real> x_;
    std::vector<Real> y_;
    std::vector<Real> xSlope_;  // control values of x' and y'
    std::vector<Real> ySlope_;
    std::vector<Sample> samples_;
};

}  // namespace caustic
