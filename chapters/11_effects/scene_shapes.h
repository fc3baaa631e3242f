#pragma once

#include <memory>

#include "scene_json.h"
#include "shape/shape.h"

namespace caustic {

/// A shape of a scene's file, without its transform.
/// @throws InputError with the place
std::shared_ptr<const Shape> readShape(const JsonPlace& place);

/// The shape, moved by the steps of a list, one after the other.
/// @throws InputError with the place
std::shared_ptr<const Shape> moved(std::shared_ptr<const Shape> shape, const JsonPlace& steps);

}  // namespace caustic
