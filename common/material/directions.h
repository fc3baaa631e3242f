#pragma once

#include <optional>

#include "math/vector.h"

namespace caustic {

/// The mirror direction of wo about a unit normal: both make the same angle with it, on the same side.
Vec3 reflected(const Vec3& wo, const Vec3& n);

/// The direction on the other side of a smooth boundary by Snell's law, unit length; nothing from the critical angle
/// on, where light is reflected totally.
/// @param wo   unit direction on the side that n points to
/// @param n    unit normal, wo · n ≥ 0
/// @param eta  index of refraction on the other side over the one on wo's side, greater than 0
std::optional<Vec3> refracted(const Vec3& wo, const Vec3& n, Real eta);

}  // namespace caustic
