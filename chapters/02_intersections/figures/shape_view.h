#pragma once

#include <functional>

#include "image/ray_view.h"
#include "shape/shape.h"

namespace caustic {

/// What a picture shows of a hit: a colour, given the hit and the unit direction to the eye.
using HitColor = std::function<Color(const Hit& hit, const Vec3& wo)>;

/// The normal as a colour: (1 + n) / 2 for each component, a little darker where the surface turns away.
Color normalColor(const Hit& hit, const Vec3& wo);

/// A checkerboard of `squares` in u and v, tinted red by u and green by v.
HitColor uvColor(const Vec2& squares);

/// Draws a shape: `samples`² rays a pixel in a regular grid, the hits' colours averaged in linear light. The same for
/// any number of threads.
Image drawShape(const Shape& shape, const RayView& view, int width, int height, int samples, const HitColor& color,
                int threads);

}  // namespace caustic
