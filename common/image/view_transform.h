#pragma once

#include "math/bounds.h"
#include "math/vector.h"

namespace caustic {

/// From the plane that is drawn (y up) to pixels (y down) and back: the same scale along both axes, no rotation.
class ViewTransform {
public:
    /// @param world  the point that lands on `pixel`
    /// @param scale  pixels per unit, greater than 0
    /// @throws InputError when a number is not finite or the scale not greater than 0
    ViewTransform(const Vec2& world, const Vec2& pixel, Real scale);

    /// Shows all of `world` as large as it goes in the middle of `pixels` with `margin` pixels left free on each side.
    /// A world without extent (one point) is shown at one unit to 100 pixels.
    /// @throws InputError when a box is empty or not finite, or the margin leaves no pixel
    static ViewTransform fit(const Bounds2& world, const Bounds2& pixels, Real margin);

    /// Where a point of the plane is drawn, and which point of the plane a pixel shows.
    /// Where a point of the world is drawn.
    Vec2 toPixel(const Vec2& world) const;
    /// Which point of the world is drawn there.
    Vec2 toWorld(const Vec2& pixel) const;
    /// Pixels per unit of the world.
    Real scale() const { return scale_; }

private:
    Vec2 origin_;  // pixel of the world's (0, 0)
    Real scale_;
};

}  // namespace caustic
