#pragma once

#include <functional>

#include "image/image.h"
#include "math/hit.h"
#include "math/ray.h"

namespace caustic {

/// Where a picture is taken from. Cameras come in chapter 05; here a picture is a grid of rays from one point.
struct Eye {
    Vec3 place;
    Vec3 target;  ///< what the middle of the picture shows
    Vec3 up = Vec3::UnitY();
    Real height = 2;  ///< of what is seen at the target's distance
};

/// What is seen along a ray.
using RayColor = std::function<Color(const Ray&)>;

/// A picture of `samples`² rays a pixel in a regular grid, averaged in linear light; the same for any number of
/// threads.
Image pictureOf(const Eye& eye, int width, int height, int samples, const RayColor& color, int threads);

/// The ray through a place of the picture, (0, 0) its upper left and (1, 1) its lower right corner.
Ray rayThrough(const Eye& eye, const Vec2& place, Real aspect);

/// A lit surface of that colour: a soft lamp from above left behind the eye, and its highlight.
Color litColor(const Hit& hit, const Vec3& wo, const Vec3& up, const Color& body);

/// What is behind everything.
Color paperColor();

}  // namespace caustic
