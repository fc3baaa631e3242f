#pragma once

#include <filesystem>

#include "mesh/mesh_data.h"

namespace caustic {

/// Reads a mesh from a file of any format: OBJ by our own reader (loadObj), PLY, STL, 3DS, COLLADA, glTF and all others
/// that the assimp library knows by assimp. All objects of the file become one mesh, each where the file's scene puts
/// it.
/// @throws InputError when the file is missing, of no known format, damaged, without a triangle, or as checkMesh does
MeshData loadMesh(const std::filesystem::path& path);

}  // namespace caustic
