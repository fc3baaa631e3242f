#pragma once

#include <string_view>
#include <vector>

#include "core/error.h"
#include "curve/bezier_spline.h"
#include "curve/svg_transform.h"

namespace caustic {

/// Turns the `d` attribute of an SVG path into splines, one for each subpath; z = 0.
///
/// All commands of SVG: M L H V C S Q T A Z, absolute and relative. Lines and parabolas become cubics exactly, arcs
/// within arcError. A subpath that Z closes is a closed spline: Z draws the line to its beginning, unless the subpath
/// came back there by itself (to 1e-9 of its coordinates, what adding up relative moves may lose; its end is then set
/// to its beginning). A subpath of a move alone draws nothing and is left out. Where a browser would draw up to the
/// first mistake, this throws.
/// @param transform  applied to what is drawn
/// @param place      where the attribute's value begins
/// @throws InputError at the first malformed command; for coordinates beyond largestCoordinate; for more than
///         mostSegments segments
std::vector<BezierSpline> parseSvgPathData(std::string_view data, const SvgTransform& transform,
                                           const InputPlace& place);

}  // namespace caustic
