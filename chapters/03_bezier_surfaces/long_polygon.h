#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "curve/bezier_curve.h"

/// Control polygons and lines in long double, for what the library's roots are held against.
namespace caustic::reference {

/// Eleven bits more than Real has.
using Long = long double;

/// A point of a profile.
struct Point {
    Long x;  ///< distance from the axis
    Long y;  ///< height
};

/// As many points as a profile of the library can have; no memory is asked for on the way.
struct Polygon {
    std::array<Point, 17> point = {};
    std::size_t count = 0;

    /// The i-th point.
    const Point& operator[](std::size_t i) const { return point[i]; }
    /// The first one.
    const Point& front() const { return point[0]; }
    /// The last one.
    const Point& back() const { return point[count - 1]; }
    /// How many there are.
    std::size_t size() const { return count; }
    /// For range-based loops.
    const Point* begin() const { return point.data(); }
    /// The same.
    const Point* end() const { return point.data() + count; }
};

/// A curve's control points.
inline Polygon polygonOf(const BezierCurve& curve) {
    Polygon polygon;
    for (const Vec3& p : curve.controlPoints()) polygon.point[polygon.count++] = {p.x(), p.y()};
    return polygon;
}

/// The point halfway.
inline Point mean(const Point& a, const Point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// Cuts a curve in two at its middle, by de Casteljau.
inline void halve(const Polygon& whole, Polygon& left, Polygon& right) {
    const std::size_t n = left.count = right.count = whole.count;
    std::copy(whole.begin(), whole.end(), right.point.begin());
    for (std::size_t i = 0; i < n; ++i) {
        left.point[i] = right.point[0];
        for (std::size_t j = 0; j + 1 < n - i; ++j) right.point[j] = mean(right.point[j], right.point[j + 1]);
    }
}

/// Length of a vector in the plane.
inline Long lengthOf(Long x, Long y) { return std::sqrt(x * x + y * y); }

/// An interval of a line's parameter.
struct Window {
    Long low;   ///< where it begins
    Long high;  ///< where it ends
};

/// A ray as a line.
struct Line {
    std::array<Long, 3> o;  ///< a point of it
    std::array<Long, 3> d;  ///< unit direction
    Long length;            ///< of the ray's direction
};

/// Where |o + t d| <= r in the plane of rotation.
inline std::optional<Window> insideCylinder(const Line& line, Long r) {
    const Long a = line.d[0] * line.d[0] + line.d[2] * line.d[2];
    if (a == 0) {
        if (line.o[0] * line.o[0] + line.o[2] * line.o[2] > r * r) return std::nullopt;
        return Window{-HUGE_VALL, HUGE_VALL};
    }
    const Long foot = -(line.o[0] * line.d[0] + line.o[2] * line.d[2]) / a;
    const Long aside = (line.o[0] * line.d[2] - line.o[2] * line.d[0]) / std::sqrt(a);
    const Long square = (r - aside) * (r + aside);
    if (square < 0) return std::nullopt;
    const Long half = std::sqrt(square / a);
    return Window{foot - half, foot + half};
}

}  // namespace caustic::reference
