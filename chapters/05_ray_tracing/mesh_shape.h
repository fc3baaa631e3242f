#pragma once

#include <filesystem>
#include <memory>

#include "shape/shape.h"

namespace caustic {

/// Reads a mesh and makes it smooth, but for its edges, where it has no normals of its own. A closed mesh whose
/// triangles face inwards is turned inside out, so that its inside is where its glass is.
/// @throws InputError as loadMesh and TriangleMesh do
std::shared_ptr<const Shape> loadShape(const std::filesystem::path& file);

}  // namespace caustic
