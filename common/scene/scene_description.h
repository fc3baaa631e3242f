#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "camera/camera.h"
#include "light/light.h"
#include "material/material.h"
#include "medium/interior.h"
#include "shape/shape.h"
#include "texture/texture.h"

namespace caustic {

/// A thing in a scene: a shape and what it does to light.
struct SceneObject {
    std::shared_ptr<const Shape> shape = nullptr;  ///< a scene refuses an object without

    /// How its surface scatters light. Without one, the surface of an object with an interior lets light pass straight
    /// on, and that of a light absorbs what it doesn't emit.
    std::shared_ptr<const Material> material = nullptr;

    /// What fills it, if it is closed and anything does. Its ng must point outwards.
    std::optional<Interior> interior = std::nullopt;

    /// Radiance that it sends out on the side of ng, over its u and v; null for none.
    std::shared_ptr<const Texture> emission = nullptr;
};

/// What a Scene is made from.
struct SceneDescription {
    std::vector<SceneObject> objects = {};
    std::vector<std::shared_ptr<Light>> lights = {};  ///< those that aren't objects: points, cones, environments

    /// Radiance from everywhere that nothing shades, W/(m²·sr): the report's constant ambient light, which stands for
    /// all the light that comes over other surfaces. Methods that compute that light leave it out.
    Color ambient = Color::Zero();

    std::shared_ptr<const Camera> camera = nullptr;  ///< may be missing when no picture is taken
};

}  // namespace caustic
