#include "mesh/mesh_file.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "mesh/gltf_file.h"
#include "mesh/obj_file.h"
#include "mesh/ply_file.h"
#include "mesh/stl_file.h"

namespace caustic {

namespace {

constexpr std::size_t mostBytes = std::size_t{1} << 30;

MeshData parse(const std::string& extension, const std::string& content, const std::filesystem::path& path) {
    if (extension == ".ply") return parsePly(content, path.string());
    if (extension == ".stl") return parseStl(content, path.string());
    return parseGltf(content, path);
}

bool isFolder(const std::filesystem::path& path) {
    std::error_code failure;
    return std::filesystem::is_directory(path, failure);
}

}  // namespace

MeshData loadMesh(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (extension == ".obj") return loadObj(path);
    const bool known = extension == ".ply" || extension == ".stl" || extension == ".gltf" || extension == ".glb";
    if (!known && !isFolder(path)) {
        throw InputError({path.string(), 0}, extension,
                         "must be an OBJ, PLY, STL, glTF or GLB file; open others in Blender and export them as glTF");
    }
    MeshData mesh = parse(extension, readTextFile(path, mostBytes), path);
    try {
        checkMesh(mesh);
    } catch (const InputError& error) {
        throw InputError({path.string() + ", " + error.place().file, 0}, error.value(), error.reason());
    }
    return mesh;
}

}  // namespace caustic
