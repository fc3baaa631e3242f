#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string_view>

namespace caustic {

/// Reads the structure of a glTF 2.0 file, text or binary (GLB), and the buffers that it names, by tinygltf. What can
/// make tinygltf 2.7 read beyond its memory or run out of stack is refused before: a binary chunk that ends after the
/// file, and JSON of more than 256 levels.
/// Source: Khronos 2021, glTF 2.0.
/// @param path  for errors; buffers in other files are looked for beside it
/// @throws InputError when it is damaged, cut short or of another version, a buffer is missing or short, or an
/// extension
///         is required that changes geometry in ways unknown here (3.12)
tinygltf::Model loadGltfModel(std::string_view content, const std::filesystem::path& path);

}  // namespace caustic
