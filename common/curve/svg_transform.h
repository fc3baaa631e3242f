#pragma once

#include <Eigen/Geometry>
#include <string_view>

#include "core/error.h"
#include "math/real.h"

namespace caustic {

/// An affine map of the plane, SVG's matrix(a b c d e f).
using SvgTransform = Eigen::Transform<Real, 2, Eigen::AffineCompact>;

/// Reads the value of a `transform` attribute: any list of matrix, translate, scale, rotate, skewX and skewY, the first
/// one outermost. Angles are in degrees.
/// @param place  where the value begins
/// @throws InputError when it is malformed, or the map is singular or too large for a double
SvgTransform parseSvgTransform(std::string_view text, const InputPlace& place);

}  // namespace caustic
