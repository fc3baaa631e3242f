#pragma once

#include <functional>

#include "image/image.h"
#include "shape/shape.h"

namespace caustic {

/// Where a picture of shapes is taken from. Cameras come in chapter 05; here a picture is a grid of rays.
struct View {
    Vec3 eye = Vec3(0, 0, 5);
    Vec3 target = Vec3::Zero();  ///< what the middle of the picture shows
    Vec3 up = Vec3::UnitY();
    Real height = 2;        ///< of what is seen at the target's distance
    bool parallel = false;  ///< parallel rays instead of rays from the eye
};

/// What a picture shows of a hit: a colour, given the hit and the unit direction to the eye.
using HitColor = std::function<Color(const Hit& hit, const Vec3& wo)>;

/// The normal as a colour: (1 + n) / 2 for each component, a little darker where the surface turns away.
Color normalColor(const Hit& hit, const Vec3& wo);

/// A checkerboard of `squares` in u and v, tinted red by u and green by v.
HitColor uvColor(const Vec2& squares);

/// Draws a shape: `samples`² rays a pixel in a regular grid, the hits' colours averaged in linear light. The same for
/// any number of threads.
Image drawShape(const Shape& shape, const View& view, int width, int height, int samples, const HitColor& color,
                int threads);

}  // namespace caustic
