#pragma once

#include <memory>
#include <string>

#include "scene/scene_description.h"
#include "texture/image_texture.h"

namespace caustic {

/// How a ball's normals are made.
enum class Normals {
    Smooth,  ///< its own
    Bare,    ///< a map's, taken as they are
    Mapped   ///< a map's, bent where they must be
};

/// A hammered ball of silver. Under a sky that is black nowhere no pixel of it may be, either.
/// @param lookup  of the map of 64 × 64 pixels, which lies 4 × 2 times around
SceneDescription dentedBall(Normals normals, Lookup lookup, std::shared_ptr<Light> sky, int side);

/// Pixels that are exactly black.
int blackPixels(const Image& picture);

}  // namespace caustic
