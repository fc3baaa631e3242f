#pragma once

#include <optional>
#include <vector>

#include "curve/arc_length.h"
#include "curve/bezier_curve.h"
#include "math/bounds.h"

namespace caustic {

/// How smoothly two segments meet; each level includes the ones before it.
enum class Continuity {
    Gap,  ///< they don't meet
    C0,   ///< they meet, perhaps in a corner
    G1,   ///< they have the same tangent direction
    C1    ///< they have the same derivative
};

/// "gap", "C0", "G1" or "C1".
const char* name(Continuity continuity);

/// From where on two segments count as meeting, as tangent, as of equal derivative. The defaults forgive what an editor
/// rounds away when it writes five digits, and nothing that an eye would see.
struct JointTolerance {
    Real distance = 1e-6;    ///< largest gap, as a share of the diagonal of the spline's control points
    Real angle = 1e-3;       ///< largest turn of the tangent, in radians
    Real derivative = 1e-3;  ///< largest difference of the derivatives, as a share of the longer one
};

/// What is found where one segment ends and the next begins.
struct Joint {
    Continuity continuity;
    Real distance;              ///< between the end and the next beginning, in the curve's units
    std::optional<Real> angle;  ///< turn of the tangent in radians, 0 to pi; none if a segment is a single point
    Real derivativeDifference;  ///< length of the difference of the derivatives, per unit of each segment's t
};

/// Cubic Bézier curves, one after the other: what the pen tool of a drawing program makes.
///
/// Whether they meet is not taken for granted but measured by joints().
class BezierSpline {
public:
    /// @param segments  at least one, of degree 3 or lower; lower ones are raised to 3, which changes no point of them
    /// @param closed    whether the last segment leads back to the first one
    /// @throws InputError when there is no segment, one is of a higher degree, or a coordinate is larger than
    ///         largestCoordinate
    explicit BezierSpline(std::vector<BezierCurve> segments, bool closed = false);

    /// @param points  3n + 1 control points; each segment begins with the point that ends the one before
    /// @throws InputError when their number is another one
    static BezierSpline fromControlPoints(const std::vector<Vec3>& points, bool closed = false);

    /// All of degree 3, in order.
    const std::vector<BezierCurve>& segments() const { return segments_; }
    bool closed() const { return closed_; }

    /// The 3n + 1 control points; nothing when a segment doesn't begin exactly where the one before it ends.
    std::optional<std::vector<Vec3>> controlPoints() const;

    /// The point at u: segment i covers [i, i + 1]. Any finite u; outside the first and the last polynomial go on.
    Vec3 position(Real u) const;

    /// Joint i lies between segment i and the next one; when closed, the last joint between the last and the first.
    std::vector<Joint> joints(const JointTolerance& tolerance = {}) const;

    /// Length of all segments together, gaps not included; the error is a proven bound, as gaussLength gives it.
    /// @param tolerance  largest error wanted, in the control points' unit; greater than 0
    /// @throws InputError when tolerance is not
    LengthEstimate length(Real tolerance) const;

    /// The smallest box of the curve, padded by the rounding bound: see exactBounds.
    Bounds3 bounds() const;

private:
    std::vector<BezierCurve> segments_;
    bool closed_;
};

}  // namespace caustic
