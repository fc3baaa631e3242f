#pragma once

#include <functional>

#include "image/image.h"
#include "mesh/mesh_tree.h"
#include "shape/shape.h"

namespace caustic {

/// Where a picture of a mesh is taken from. Cameras come in chapter 05; here a picture is a grid of rays.
struct MeshView {
    Vec3 eye = Vec3(0, 0, 5);
    Vec3 target = Vec3::Zero();  ///< what the middle of the picture shows
    Real height = 2;             ///< of what is seen at the target's distance
};

/// A view of a box from the direction `from`, with some room around it.
MeshView viewOf(const Bounds3& box, const Vec3& from);

/// The ray through a place of the picture; (0, 0) is the upper left corner, (1, 1) the lower right one.
Ray rayThrough(const MeshView& view, const Vec2& place, Real aspect);

/// The colour of each pixel: that of its rays, `samples`² in a regular grid, averaged in linear light. The same for any
/// number of threads.
Image drawRays(const MeshView& view, int width, int height, int samples, const std::function<Color(const Ray&)>& color,
               int threads);

/// Plaster under two lights and a pale sky, shaded by the shading normal.
Color plaster(const Hit& hit, const Vec3& wo);

/// What is behind everything.
Color paperColor();

}  // namespace caustic
