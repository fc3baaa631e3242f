#pragma once

#include <filesystem>

#include "mesh/mesh_data.h"

namespace caustic {

/// Reads a mesh from a file of a kind that its ending names: OBJ (parseObj), PLY (parsePly), STL (parseStl), glTF and
/// GLB (parseGltf). All objects of the file become one mesh. Coordinates are those that the file holds, to their last
/// bit, moved only by what the file itself says.
/// @throws InputError when the file is missing, of any other kind, over 1 GiB, damaged, without a triangle, or as
///         checkMesh does
MeshData loadMesh(const std::filesystem::path& path);

}  // namespace caustic
