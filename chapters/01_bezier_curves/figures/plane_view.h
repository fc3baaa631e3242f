#pragma once

#include <string>
#include <vector>

#include "curve/bezier_curve.h"
#include "image/drawing.h"
#include "math/bounds.h"

namespace caustic {

/// A window onto the plane z = 0: maps points with y upwards to a rectangle of a drawing, at one scale for both axes
/// and in its middle.
class PlaneView {
public:
    /// @param world   what has to be seen, in the curves' unit
    /// @param pixels  where, in pixels of the drawing, y down
    PlaneView(const Bounds2& world, const Bounds2& pixels);

    /// Where something of the plane lies on the drawing, and how long a unit is there.
    Vec2 toPixels(const Vec3& point) const;
    std::vector<Vec2> toPixels(const std::vector<Vec3>& points) const;
    Bounds2 toPixels(const Bounds3& box) const;
    Real pixelsPerUnit() const { return scale_; }

private:
    Real scale_;
    Vec2 worldCentre_;
    Vec2 pixelCentre_;
};

/// The curve's points at count + 1 even parameters of [from, to].
std::vector<Vec3> samplePoints(const BezierCurve& curve, int count, Real from = 0, Real to = 1);

/// A filled dot with a thin rim of the paper's colour, so that dots on lines stay apart.
void drawDot(Drawing& drawing, const Vec2& place, Real radius, const Ink& ink);

/// A symbol with an index below and one above, as in P with 1 and (2); either may be empty. `place` is the middle of
/// the symbol.
void drawSymbol(Drawing& drawing, const Vec2& place, const std::string& symbol, const std::string& below,
                const std::string& above, const Ink& ink, Real size);

/// A figure's or a panel's title, left-aligned on a baseline, with a line of explanation below it.
void drawTitle(Drawing& drawing, const Vec2& place, const std::string& title, const std::string& explanation,
               Real size = 24);

/// share 0 gives a, share 1 gives b.
Ink mixed(const Ink& a, const Ink& b, Real share);

}  // namespace caustic
