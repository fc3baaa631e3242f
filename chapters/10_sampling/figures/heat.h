#pragma once

#include "image/drawing.h"
#include "integrator/adaptive.h"

namespace caustic {

/// From black through red and yellow to white, brighter all the way, by the logarithm of a number of paths.
/// @param paths  at least 1
Color heatOf(Real paths, Real least, Real most);

/// How many paths each pixel has had.
Image heatMap(const AdaptiveIntegrator& integrator, Real least, Real most);

/// What the colours stand for: a strip with numbers below.
void drawHeatScale(Drawing& drawing, const Vec2& corner, int width, Real least, Real most);

}  // namespace caustic
