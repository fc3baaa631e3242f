#pragma once

#include "scene/scene_description.h"

namespace caustic {

/// The box in which path tracers are held against each other: coloured walls, a mirror ball, a glass ball, a lamp at
/// the ceiling, an open front. z is up and the camera looks along y. Source: SmallVCM's Cornell box.
///
/// Its walls count on the inner side only. They need nothing for that: light that leaves through the front comes back
/// to no outer side.
/// @param width, height  of the picture in pixels; the field of view is 45° from below to above
/// @throws InputError for a size that is none of an image
SceneDescription peersBox(int width, int height);

/// Segments from the eye to the light, at most, with which the box is rendered.
inline constexpr int peersBoxSegments = 10;

}  // namespace caustic
