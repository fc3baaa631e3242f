#include <gtest/gtest.h>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "mesh/mesh_file.h"
#include "mesh/obj_file.h"
#include "mesh/triangle_mesh.h"
#include "support/measured_process.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

namespace fs = std::filesystem;

TEST(MeshFile, MissingFilesAndFoldersAreRefused) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(loadMesh(folder / "none.obj"), InputError);
    EXPECT_THROW(loadMesh(folder / "none.ply"), InputError);
    EXPECT_THROW(loadMesh(folder.path()), InputError);
    fs::create_directory(folder / "folder.obj");
    EXPECT_THROW(loadMesh(folder / "folder.obj"), InputError);
    for (const char* name : {"mesh.ply", "mesh.stl", "mesh.3ds", "mesh.gltf", "mesh.glb", "mesh.xyz", "mesh"}) {
        EXPECT_THROW(loadMesh(folder.write(name, "solid nothing")), InputError) << name;
        EXPECT_THROW(loadMesh(folder.write(name, "")), InputError) << name;
    }
    // Half of a file that is fine.
    const std::string whole =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_EQ(loadMesh(folder.write("whole.ply", whole)).triangles.size(), 1U);
    EXPECT_THROW(loadMesh(folder.write("half.ply", whole.substr(0, 150))), InputError);
}

TEST(MeshFile, OtherKindsAreRefusedWithTheWayOut) {
    const test::TemporaryFolder folder;
    for (const char* name : {"mesh.3ds", "mesh.dae", "mesh.FBX", "mesh"}) {
        try {
            loadMesh(folder.write(name, "anything"));
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("export them as glTF"), std::string::npos) << error.what();
        }
    }
}

TEST(Mesh, WhatMakesNoMeshIsRefused) {
    MeshData mesh;
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "empty";
    mesh.positions = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    mesh.triangles = {{0, 1, 1}};
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "no area at all";
    mesh.triangles = {{0, 1, 2}, {0, 1, 1}, {0, 0, 0}};
    const TriangleMesh one(mesh);
    EXPECT_TRUE(one.intersect({Vec3(0.2, 0.2, 1), -Vec3::UnitZ()}).has_value()) << "faces without area are passed over";
    mesh.triangles = {{0, 1, 3}};
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "a vertex that isn't there";
    mesh.triangles = {{0, 1, 2}};
    mesh.normalCorners = {{0, 0, 0}};
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "a normal that isn't there";
    mesh.normalCorners.clear();
    mesh.uvCorners = {{0, 0, 0}, {0, 0, 0}};
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "more triples than triangles";
    mesh.uvCorners.clear();
    mesh.positions[1].y() = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "NaN vertex";
    mesh.positions[1].y() = std::numeric_limits<Real>::infinity();
    EXPECT_THROW(TriangleMesh{mesh}, InputError) << "infinite vertex";
}

std::vector<fs::path> modelsOf(const std::string& extension) {
    const fs::path models = "/usr/share/assimp/models";
    std::vector<fs::path> found;
    if (!fs::is_directory(models)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(models)) {
        if (entry.path().extension() == extension) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    return found;
}

// Files that nobody here wrote: they load, or it is said what is wrong.
TEST(RealFiles, LoadOrSayWhatIsWrong) {
    std::size_t files = 0;
    std::size_t loaded = 0;
    for (const char* extension : {".obj", ".ply", ".stl", ".gltf", ".glb"}) {
        for (const fs::path& file : modelsOf(extension)) {
            ++files;
            try {
                const MeshData mesh = loadMesh(file);
                checkMesh(mesh);
                ++loaded;
            } catch (const InputError& error) {
                EXPECT_TRUE(error.place().file.starts_with(file.string())) << error.what();
                EXPECT_FALSE(error.reason().empty()) << file;
                EXPECT_EQ(error.reason().find('\n'), std::string::npos) << file;
            }
        }
    }
    EXPECT_GE(files, 50U) << "Is assimp-testmodels installed? ./course setup --group test does it.";
    EXPECT_GE(loaded, 40U);
}

// tinyobjloader shares no code with our reader. Faces in order: the same corners where a face is a triangle, the same
// vertices where it was cut.
void compare(const MeshData& mesh, const tinyobj::ObjReader& other, const std::string& file) {
    const tinyobj::attrib_t& attributes = other.GetAttrib();
    ASSERT_EQ(mesh.positions.size(), attributes.vertices.size() / 3) << file;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float ours = static_cast<float>(mesh.positions[i][static_cast<Eigen::Index>(axis)]);
            ASSERT_NEAR(ours, attributes.vertices[3 * i + axis], 1e-6F * std::max(1.0F, std::abs(ours))) << file;
        }
    }
    std::size_t next = 0;
    for (const tinyobj::shape_t& shape : other.GetShapes()) {
        std::size_t corner = 0;
        for (const unsigned count : shape.mesh.num_face_vertices) {
            ASSERT_LE(next + count - 2, mesh.triangles.size()) << file;
            std::vector<int> theirs;
            for (unsigned k = 0; k < count; ++k) theirs.push_back(shape.mesh.indices[corner + k].vertex_index);
            std::vector<int> ours;
            for (std::size_t t = next; t < next + count - 2; ++t) {
                for (const std::uint32_t index : mesh.triangles[t]) ours.push_back(static_cast<int>(index));
            }
            if (count == 3) {
                ASSERT_EQ(ours, theirs) << file;
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto& index = shape.mesh.indices[corner + k];
                    const auto named = [&](const std::vector<MeshData::Corners>& all) {
                        return all.empty() ? -1 : static_cast<int>(all[next][k]);  // none is -1
                    };
                    ASSERT_EQ(named(mesh.normalCorners), index.normal_index) << file;
                    ASSERT_EQ(named(mesh.uvCorners), index.texcoord_index) << file;
                }
            } else {
                std::ranges::sort(ours);
                ours.erase(std::unique(ours.begin(), ours.end()), ours.end());
                std::ranges::sort(theirs);
                theirs.erase(std::unique(theirs.begin(), theirs.end()), theirs.end());
                ASSERT_EQ(ours, theirs) << file;
            }
            next += count - 2;
            corner += count;
        }
    }
    EXPECT_EQ(next, mesh.triangles.size()) << file;
}

TEST(RealFiles, AgreeWithTinyobjloader) {
    std::vector<fs::path> files = modelsOf(".obj");
    files.push_back(test::sourceDir() / "assets/meshes/bunny_low.obj");
    std::size_t compared = 0;
    for (const fs::path& file : files) {
        // A face of 936 corners: tinyobjloader counts them in a byte.
        if (file.filename() == "box_longline.obj") continue;
        tinyobj::ObjReaderConfig config;
        config.triangulate = false;
        tinyobj::ObjReader other;
        if (!other.ParseFromFile(file.string(), config)) continue;
        MeshData mesh;
        try {
            mesh = loadMesh(file);
        } catch (const InputError&) {
            continue;
        }
        compare(mesh, other, file.filename().string());
        ++compared;
    }
    EXPECT_GE(compared, 15U);
}

TEST(Inspect, PrintsJsonAndRefusesWhatIsNoMesh) {
    const test::TemporaryFolder folder;
    const auto low = (test::sourceDir() / "assets/meshes/bunny_low.obj").string();
    const test::MeasuredRun fine = test::runMeasured({test::chapterProgram(), "--inspect", low}, folder.path());
    EXPECT_EQ(fine.exitCode, 0) << fine.errors;
    EXPECT_NE(fine.output.find("\"triangles\": 3674"), std::string::npos) << fine.output;
    EXPECT_NE(fine.output.find("\"watertight\":"), std::string::npos);
    EXPECT_NE(fine.output.find("megaraysPerSecond"), std::string::npos);
    const test::MeasuredRun stray = test::runMeasured(
        {test::chapterProgram(), "--inspect", (test::sourceDir() / "tests/04_kd_tree/field/stray_vertex.obj").string()},
        folder.path());
    EXPECT_EQ(stray.exitCode, 0) << stray.errors;
    EXPECT_NE(stray.output.find("\"unusedVertices\": 1"), std::string::npos) << stray.output;
    for (const char* text : {"v 0 0 abc\n", "f 1 2\n", "v 0 0 0\nf 1 -9 1\n"}) {
        const fs::path file = folder.write("bad.obj", text);
        const test::MeasuredRun run =
            test::runMeasured({test::chapterProgram(), "--inspect", file.string()}, folder.path());
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
        EXPECT_TRUE(run.output.empty());
    }
}

}  // namespace
}  // namespace caustic
