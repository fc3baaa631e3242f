#pragma once

#include <memory>

#include "curve/bezier_spline.h"
#include "scene/scene_description.h"

namespace caustic {

/// A glass of wine as two bodies of revolution around the y axis, standing on y = 0: exact surfaces, no mesh.
///
/// The wine reaches into the glass a little, and the glass has the higher priority. So light goes from glass to wine
/// straight, over one boundary; if the two met at the same place, or left a gap, it would cross none, or air.
struct WineGlass {
    /// Half the outline of the glass, m: from the axis at the bottom along the outside to the rim, and inside down to
    /// the axis again.
    BezierSpline outline;

    Real glassIor = 1.52;  ///< index of refraction of the glass
    Real wineIor = 1.345;  ///< and of the wine
    Real level = 0.145;    ///< height of the wine's surface, m; within the bowl

    /// Absorption coefficient of the wine, 1/m.
    Color wineSigmaA = {4, 40, 32};

    /// Glass and wine.
    /// @throws InputError when the level isn't within the bowl
    std::vector<SceneObject> objects() const;

    /// The glass alone, empty.
    SceneObject glass() const;

    /// The outline of the wine: from the axis at its bottom along the wall to its surface, and back to the axis.
    /// @throws InputError when the level isn't within the bowl
    std::vector<BezierCurve> wineOutline() const;
};

/// Reads a glass's outline from a drawing in millimetres: as loadProfile, in metres.
/// @throws InputError as loadProfile does
BezierSpline loadOutline(const std::string& file);

}  // namespace caustic
