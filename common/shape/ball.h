#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "core/not_implemented.h"
#include "math/interval.h"

namespace caustic {

/// The t for which the line t · direction is in a closed ball, t of either sign. In the plane the ball is a disc: that
/// is a cylinder seen along its axis, and a zero direction (a line along the axis) is in it always or never.
///
/// The report's projection: the centre's foot on the line, then Pythagoras from there. The distance from the foot is
/// measured as a vector; as a difference of squares it would lose all its digits to a far ball (chapter 02's chart).
/// Source: Haines, Günther, Akenine-Möller 2019, Precision Improvements for Ray/Sphere Intersection, Ray Tracing
/// Gems 7.
/// @param toCenter   from the line's point t = 0 to the centre
/// @param direction  of any length, in which t counts; it may be zero
/// @param radius     greater than zero
/// @return {∞, −∞}, which is empty, when the line misses the ball; {−∞, ∞} when it is always in it
template <typename Scalar, int Dimension>
BasicInterval<Scalar> ballInterval(const Eigen::Matrix<Scalar, Dimension, 1>& toCenter,
                                   const Eigen::Matrix<Scalar, Dimension, 1>& direction, Scalar radius) {
    //! [ex-02.2]
    constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();
    const Scalar lengthSquared = direction.squaredNorm();
    if (lengthSquared == 0) {
        if (toCenter.squaredNorm() <= radius * radius) return {-infinity, infinity};
        return {infinity, -infinity};
    }
    const Scalar foot = toCenter.dot(direction) / lengthSquared;
    const Eigen::Matrix<Scalar, Dimension, 1> fromFoot = toCenter - foot * direction;
    const Scalar halfChordSquared = radius * radius - fromFoot.squaredNorm();
    if (!(halfChordSquared >= 0)) return {infinity, -infinity};
    const Scalar half = std::sqrt(halfChordSquared / lengthSquared);
    return {foot - half, foot + half};
    //! [ex-02.2]
}

}  // namespace caustic
