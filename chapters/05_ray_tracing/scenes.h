#pragma once

#include <memory>

#include "scene/scene_description.h"

namespace caustic {

/// What the pictures of this chapter show.

/// Glass in the report's way: it refracts all light and reflects none but what is reflected totally.
std::shared_ptr<const Material> clearGlass();

/// What fills a glass of index 1.5 of which one unit of length lets this share pass: the report's I.
Interior glassOf(const Color& perUnit);

/// A room of 5 × 4 × 9.5 with a checkered floor, coloured walls at the sides and no lamp: x to the right, y up, z to
/// the viewer; the floor is y = 0.
SceneDescription emptyRoom();

/// Lets a rectangle in the middle of the room's ceiling shine, and gives the corners some ambient light.
void addLamp(SceneDescription& scene);

/// A camera in the room that looks at the middle of what stands on its floor.
std::shared_ptr<const Camera> roomCamera(int width, int height);

/// A ball of radius 1 on the floor.
SceneObject ballOnFloor(std::shared_ptr<const Material> material);

/// The report's box: a mirror ball and a glass ball under a lamp.
SceneDescription boxScene(int width, int height);

/// A shape whose lowest point is at y = 0, in glass or any other material, on a white floor under a lamp.
/// The camera stands as far away as the shape's box wants.
SceneDescription meshScene(const SceneObject& object, int width, int height);

}  // namespace caustic
