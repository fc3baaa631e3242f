#pragma once

#include "curve/bezier_curve.h"

namespace caustic {

/// The cubic of the construction's picture, and the smooth one of the length chart: an arch, each level of whose
/// construction lies apart from the others.
inline BezierCurve archCurve() {
    return BezierCurve({Vec3(0, 0, 0), Vec3(0.9, 3.6, 0), Vec3(4.6, 4, 0), Vec3(6, 0.6, 0)});
}

/// Control points that lie close together on the left and far apart on the right: slow first, fast later.
inline BezierCurve unevenCurve() {
    return BezierCurve(
        {Vec3(0, 0, 0), Vec3(0.2, 1.6, 0), Vec3(0.5, 2.6, 0), Vec3(3.2, 3.4, 0), Vec3(6, -4, 0), Vec3(8, 2.2, 0)});
}

}  // namespace caustic
