#pragma once

#include <cstdint>

#include "image/image.h"
#include "modeler/caustic_scene.h"

namespace caustic {

/// What CausticScene::onFloor looks like, by a program of its own that knows this scene only: a sphere by its formula,
/// Snell and Fresnel by theirs, cells on the floor that count light. It shares no ray, no BSDF and no light with those
/// who are judged by it. In the picture each pixel is one square of floor, so no camera is needed either.
///
/// Light straight from the lamp is a sum over points of the lamp and of each cell. Light through the ball is followed
/// in both directions at each boundary, so all the chance that is left is where it sets out; so is light that comes
/// back to the floor over the ball.
/// @param width   of the picture in pixels, at least 1
/// @param photons  that set out to the ball, at least 1
/// @param threads  at least 1; the picture doesn't depend on it
Image causticReference(const CausticScene& scene, int width, std::int64_t photons, int threads, std::uint64_t seed);

}  // namespace caustic
