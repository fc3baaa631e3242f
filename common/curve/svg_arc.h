#pragma once

#include <vector>

#include "math/vector.h"

namespace caustic {

/// The end of a cubic piece whose beginning is known.
struct CubicPiece {
    Vec2 control1;
    Vec2 control2;
    Vec2 end;
};

/// An arc of an ellipse as SVG's path command A gives it.
struct SvgArc {
    Vec2 from;
    Vec2 radii;          ///< their signs don't count
    Real rotation = 0;   ///< of the ellipse's x axis, in degrees
    bool large = false;  ///< whether the longer way round
    bool sweep = false;  ///< whether the angle grows: clockwise on the page, where y points down
    Vec2 to;
};

/// Greatest distance of a piece from the ellipse, in units of the ellipse's radii (stretch it to a circle of radius 1
/// to see it): pieces of at most 45 degrees are off by 2/27 sin^6(45/4) / cos^2(45/4) = 4.25e-6 (Goldapp 1991).
constexpr Real arcError = 4.3e-6;

/// Cubic pieces of at most 45 degrees along the arc; the last one ends exactly at `to`.
///
/// Signs of radii are dropped; radii that are too small to reach are scaled up; a zero radius makes a line; equal ends
/// make nothing.
/// Source: SVG 2, 9.5.1 (out-of-range elliptical arc parameters) and B.2.
std::vector<CubicPiece> arcToCubics(const SvgArc& arc);

/// A straight line as a cubic: its controls divide it in three.
CubicPiece lineToCubic(const Vec2& from, const Vec2& to);

/// A parabola as a cubic, by raising its degree.
CubicPiece quadraticToCubic(const Vec2& from, const Vec2& control, const Vec2& to);

}  // namespace caustic
