#pragma once

#include <Eigen/Core>

#include "math/real.h"

namespace caustic {

/// Linear RGB with sRGB primaries. Arithmetic is componentwise. Whether it is radiance (W/(m²·sr)), a reflectance
/// (unitless) or a transmittance is said where it is used.
using Color = Eigen::Array<Real, 3, 1>;

/// Relative luminance, with the weights of ITU-R BT.709.
inline Real luminance(const Color& color) {
    return Real(0.2126) * color.x() + Real(0.7152) * color.y() + Real(0.0722) * color.z();
}

}  // namespace caustic
