#pragma once

#include <filesystem>
#include <string_view>

#include "mesh/mesh_data.h"

namespace caustic {

/// Reads the triangles of a glTF 2.0 file's scene, text or binary: triangles, strips and fans of all its nodes, moved
/// by their transforms into one mesh. A node that mirrors turns its triangles over, so that their outsides stay
/// outside. Normals and the first texture coordinates come along, with v upwards as in OBJ. Points and lines have no
/// triangles; materials, cameras and animations are not looked at. Source: Khronos 2021, glTF 2.0, 3.5 to 3.7.
/// @param path  for errors; buffers in other files are looked for beside it
/// @throws InputError as loadGltfModel and GltfAccessors; when there is no scene or no triangle, nodes make no tree, a
///         transform has too few or too many numbers, an index names no vertex (with its accessor), or what shapes the
///         mesh is not followed: skins, morph targets with weights, instances by EXT_mesh_gpu_instancing
MeshData parseGltf(std::string_view content, const std::filesystem::path& path);

}  // namespace caustic
