#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vector.h"

namespace caustic {

/// The most corners that a polygon with a concave corner may have: cutting ears off takes time that grows with their
/// square, or worse. Convex ones may have any number.
inline constexpr std::size_t mostConcaveCorners = 2000;

/// Cuts a polygon into triangles that cover it and go round the same way, n - 2 of them for n corners.
///
/// A convex one becomes a fan around its first corner, a concave one loses an ear at a time. Corners need not be
/// exactly in a plane; the polygon is seen along its mean normal (Newell's). One that crosses itself, or has no
/// area, is cut somehow, into n - 2 triangles all the same. Source: Meisters 1975, Polygons Have Ears.
/// @param corners  at least three; at most mostConcaveCorners unless it is convex
/// @return the corners' numbers within `corners`
std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Vec3> corners);

/// Whether all corners of a polygon turn the same way, seen along its mean normal.
bool isConvex(std::span<const Vec3> corners);

}  // namespace caustic
