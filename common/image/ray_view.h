#pragma once

#include <functional>

#include "image/image.h"
#include "math/ray.h"

namespace caustic {

/// Where a picture is taken from before there are cameras (chapter 05): a regular grid of rays.
struct RayView {
    Vec3 eye = Vec3(0, 0, 5);
    Vec3 target = Vec3::Zero();  ///< what the middle of the picture shows
    Vec3 up = Vec3::UnitY();
    Real height = 2;        ///< of what is seen at the target's distance
    bool parallel = false;  ///< parallel rays instead of rays from the eye
};

/// The ray through a place of a picture that is `aspect` times as wide as high; (0, 0) is the upper left corner, (1, 1)
/// the lower right one.
Ray rayThrough(const RayView& view, const Vec2& place, Real aspect);

/// A picture of `samples`² colours a pixel in a regular grid, averaged in linear light. The same for any number of
/// threads.
/// @param color  of a place of the picture, (0, 0) to (1, 1); called by many threads at once
Image supersampled(int width, int height, int samples, const std::function<Color(const Vec2&)>& color, int threads);

/// The same for what is seen along the view's rays.
Image supersampled(const RayView& view, int width, int height, int samples,
                   const std::function<Color(const Ray&)>& color, int threads);

/// What is behind everything.
Color paperColor();

}  // namespace caustic
