#pragma once

#include <vector>

#include "scene/scene.h"

namespace caustic {

/// Pixels in which a lamp is seen straight, and those around them: row by row from the top.
/// @param reach  how many pixels around
std::vector<bool> pixelsNearLamps(const Scene& scene, int reach);

}  // namespace caustic
