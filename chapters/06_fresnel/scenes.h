#pragma once

#include <memory>

#include "scene/scene_description.h"

namespace caustic {

/// What the pictures of this chapter show.

/// A glass block, a solid glass ball and a hollow one on a checkered floor, between coloured walls, a lamp above.
/// @param glass  what their surfaces are made of; inside is glass of index 1.5
SceneDescription glassScene(std::shared_ptr<const Material> glass, int width, int height);

/// A ball on a checkered floor under two bright panels, in a faint grey environment.
/// @param glass  whether it is filled with glass of index 1.5
SceneDescription ballScene(std::shared_ptr<const Material> material, bool glass, int width, int height);

/// A pane of clear glass between the origin and a lamp of radiance 1 further along x.
/// @param glass  its two faces, x = 0 and x = 1
SceneDescription paneScene(std::shared_ptr<const Material> glass, Real ior);

}  // namespace caustic
