#pragma once

#include "curve/bezier_spline.h"
#include "image/image.h"

namespace caustic {

/// What a revolved profile is shaded as; colours are linear RGB.
struct RevolvedLook {
    Color body;        ///< seen face on
    Color edge;        ///< seen edge on
    Real highlight;    ///< strength of the lamp's mirror image, 0 to 1
    bool transparent;  ///< whether a white background shines through where the body is seen face on
};

/// The left half of the solid that a profile makes when it is revolved about x = 0, seen from the side in parallel
/// projection before white. A foretaste of chapter 03, which follows rays instead.
///
/// In this view the silhouette is all that matters: at each height the largest radius r, and at x = -r ... 0 the normal
/// (x/r, -r', sqrt(1 - x²/r²)).
/// @param pixelsPerUnit  scale; the picture covers x from -width to 0 and the profile's heights
Image shadeRevolved(const BezierSpline& profile, const RevolvedLook& look, Real pixelsPerUnit);

}  // namespace caustic
