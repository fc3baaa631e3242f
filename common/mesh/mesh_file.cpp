#include "mesh/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "mesh/obj_file.h"
#include "mesh/ply_check.h"

namespace caustic {

namespace {

constexpr std::size_t mostBytes = std::size_t{1} << 30;

Vec3 toVec3(const aiVector3D& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }

void append(const aiMesh& from, MeshData& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto firstNormal = static_cast<std::uint32_t>(mesh.normals.size());
    const auto firstUv = static_cast<std::uint32_t>(mesh.uvs.size());
    const bool hasNormals = from.HasNormals();
    const bool hasUvs = from.HasTextureCoords(0);
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        mesh.positions.push_back(toVec3(from.mVertices[i]));
        if (hasNormals) mesh.normals.push_back(toVec3(from.mNormals[i]));
        if (hasUvs) mesh.uvs.emplace_back(Real(from.mTextureCoords[0][i].x), Real(from.mTextureCoords[0][i].y));
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines
        MeshData::Corners corners;
        MeshData::Corners normals;
        MeshData::Corners uvs;
        for (unsigned k = 0; k < 3; ++k) {
            corners[k] = first + face.mIndices[k];
            normals[k] = hasNormals ? firstNormal + face.mIndices[k] : MeshData::none;
            uvs[k] = hasUvs ? firstUv + face.mIndices[k] : MeshData::none;
        }
        mesh.triangles.push_back(corners);
        mesh.normalCorners.push_back(normals);
        mesh.uvCorners.push_back(uvs);
    }
}

// Where assimp 5.2 cuts faces into triangles, one without corners stops the program, by an assertion.
void checkFaces(const aiScene& scene, const std::filesystem::path& path) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        const auto broken = [&](const aiFace& face) {
            const auto beyond = [&](unsigned corner) { return corner >= mesh.mNumVertices; };
            return face.mNumIndices == 0 || std::any_of(face.mIndices, face.mIndices + face.mNumIndices, beyond);
        };
        const aiFace* const first = mesh.mFaces;
        const aiFace* const end = first + mesh.mNumFaces;
        const aiFace* const found = std::find_if(first, end, broken);
        if (found == end) continue;
        throw InputError({path.string(), 0}, "face " + std::to_string(found - first),
                         "has no corners, or one that isn't there");
    }
}

MeshData loadByAssimp(const std::filesystem::path& path) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const unsigned steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                           aiProcess_PreTransformVertices;
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    if (scene != nullptr) {
        checkFaces(*scene, path);
        scene = importer.ApplyPostProcessing(steps);
    }
    if (scene == nullptr) {
        const std::string reason = importer.GetErrorString();
        throw InputError({path.string(), 0}, "", reason.substr(0, reason.find('\n')));
    }
    MeshData mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], mesh);
    if (mesh.triangles.empty()) throw InputError({path.string(), 0}, "", "has no triangle");
    if (mesh.normals.empty()) mesh.normalCorners.clear();
    if (mesh.uvs.empty()) mesh.uvCorners.clear();
    return mesh;
}

void checkReadable(const std::filesystem::path& path) {
    std::error_code failure;
    if (!std::filesystem::exists(path, failure)) throw InputError({path.string(), 0}, "", "no such file");
    if (std::filesystem::is_directory(path, failure)) {
        throw InputError({path.string(), 0}, "", "is a folder, not a file");
    }
}

}  // namespace

MeshData loadMesh(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".obj") return loadObj(path);

    checkReadable(path);
    if (extension == ".ply") checkPly(readTextFile(path, mostBytes), path);
    MeshData mesh = loadByAssimp(path);
    try {
        checkMesh(mesh);
    } catch (const InputError& error) {
        throw InputError({path.string() + ", " + error.place().file, 0}, error.value(), error.reason());
    }
    return mesh;
}

}  // namespace caustic
