#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Renders a mesh on a floor under a lamp: 05_ray_tracing/mesh.png in the folder for figures.
/// @param file      OBJ or any other format that loadMesh knows
/// @param material  "glass", "diffuse" or "mirror"
/// @throws InputError when the file can't be read or there is no such material
void renderMesh(const std::string& file, const std::string& material, const ChapterInputs& inputs,
                const ChapterOptions& options);

}  // namespace caustic
