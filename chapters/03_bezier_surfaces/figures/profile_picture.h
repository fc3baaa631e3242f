#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Draws a profile's surface of revolution to `out/03_bezier_surfaces/revolved.png`.
/// @param file  as loadProfile takes it: an SVG file, perhaps with a path's id, or control points
/// @throws InputError for bad files, and for profiles without area
void drawProfile(const std::string& file, const ChapterOptions& options);

}  // namespace caustic
