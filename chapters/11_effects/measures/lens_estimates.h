#pragma once

#include "camera/thin_lens_camera.h"
#include "core/random.h"

namespace caustic {

/// A camera for measuring, at the origin, that looks along −z and is focused at 4 m.
ThinLensCamera measuringCamera();

/// The diameter of a point's blur, estimated by where it is seen through points of the lens, in pixels: four times the
/// root mean square distance from its middle along an axis, as a uniform disc has it.
/// @param depth       of the point before the camera, m
/// @param side        square root of the number of points
/// @param stratified  whether there is one in each cell of a grid, or all are random
Real measuredBlur(const ThinLensCamera& camera, Real depth, int side, bool stratified, Random& random);

}  // namespace caustic
