#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "math/vector.h"

namespace caustic {

/// An affine map of the plane, SVG's matrix(a b c d e f).
using SvgTransform = Eigen::Transform<Real, 2, Eigen::AffineCompact>;

/// Reads the value of a `transform` attribute: any list of matrix, translate, scale, rotate, skewX and skewY, the first
/// one outermost. Angles are in degrees.
/// Source: SVG 1.1, 7.6; CSS Transforms 1, 8.
/// @param place  where the value begins
/// @throws InputError when it is malformed, or the map is singular or too large for a double
SvgTransform parseSvgTransform(std::string_view text, const InputPlace& place);

/// Reads the value of CSS's property `transform`, which takes more functions than the attribute, needs commas between
/// numbers and units after lengths and angles.
/// Source: CSS Transforms 1, 11 (two-dimensional functions).
/// @return nothing when it can't be followed: functions in space, percentages of lengths, units that depend on a font
/// @throws InputError when the map is singular or too large for a double
std::optional<SvgTransform> parseCssTransform(std::string_view text, const InputPlace& place);

/// Reads the value of `transform-origin` as two lengths, with a third one for z that must be 0.
/// @param css  whether it stands in a style, where lengths need units
/// @return nothing when it is anything else: keywords and percentages, which depend on a box
std::optional<Vec2> parseTransformOrigin(std::string_view text, bool css);

}  // namespace caustic
