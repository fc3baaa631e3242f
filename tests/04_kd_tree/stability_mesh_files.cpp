#include <gtest/gtest.h>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <filesystem>
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

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct BadFile {
    std::string name;
    std::string text;
    std::size_t line;
    std::string value;
};

const std::vector<BadFile> badFiles = {
    {"no number", "v 0 0 abc\n", 1, "abc"},
    {"a number and rubbish", "v 0 0 1.5x\n", 1, "1.5x"},
    {"NaN", "\n# comment\nv 0 nan 0\n", 3, "nan"},
    {"infinity", "v inf 0 0\n", 1, "inf"},
    {"overflow", "v 1e999 0 0\n", 1, "1e999"},
    {"two coordinates", "v 1 2\n", 1, ""},
    {"weight is no number", "v 1 2 3 w\n", 1, "w"},
    {"normal of two", "vn 1 2\n", 1, ""},
    {"NaN normal", "vn 1 2 nan\n", 1, "nan"},
    {"uv without numbers", "vt\n", 1, ""},
    {"face of two", square + "f 1 2\n", 5, "2 corners"},
    {"face of none", square + "f\n", 5, "0 corners"},
    {"number 0", square + "f 0 1 2\n", 5, "0"},
    {"before the first", square + "f -9 1 2\n", 5, "-9"},
    {"beyond the last", square + "f 1 2 3\nf 1 2 5\nf 1 2 3\n", 6, "5"},
    {"no such uv", square + "f 1/1 2/1 3/1\n", 5, "1"},
    {"no such normal", square + "f 1//-1 2//-1 3//-1\n", 5, "-1"},
    {"huge number", square + "f 1 2 99999999999999999999\n", 5, "99999999999999999999"},
    {"beyond 32 bits", square + "f 1 2 4294967296\n", 5, "4294967296"},
    {"corner without a vertex", square + "f /1 2 3\n", 5, "/1"},
    {"four numbers a corner", square + "f 1/1/1/1 2 3\n", 5, "1/1/1/1"},
    {"a float for a number", square + "f 1.5 2 3\n", 5, "1.5"},
    {"line after CR LF", "v 0 0 0\r\nv 0 0 x\r\n", 2, "x"},
    {"UTF-16", std::string("\xff\xfe", 2) + "v", 1, ""},
};

// Place, value and nothing else: what a person needs to find the mistake.
TEST(ObjFile, BadInputIsNamedWithItsLine) {
    for (const BadFile& bad : badFiles) {
        try {
            parseObj(bad.text, "bad.obj");
            ADD_FAILURE() << bad.name << " was accepted";
        } catch (const InputError& error) {
            EXPECT_EQ(error.place().file, "bad.obj") << bad.name;
            EXPECT_EQ(error.place().line, bad.line) << bad.name << ": " << error.what();
            EXPECT_EQ(error.value(), bad.value) << bad.name << ": " << error.what();
        }
    }
}

TEST(ObjFile, EmptyAndTruncatedFilesAreRefused) {
    for (const std::string text : {"", "\n", "# nothing\n", "v 0 0 0\n", "f", "v", "\\", "\\\n", "f 1 2 \\\n3\n"}) {
        EXPECT_THROW(parseObj(text, "bad.obj"), InputError) << '"' << text << '"';
    }
}

TEST(ObjFile, MissingFilesAndFoldersAreRefused) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(loadMesh(folder / "none.obj"), InputError);
    EXPECT_THROW(loadMesh(folder / "none.ply"), InputError);
    EXPECT_THROW(loadMesh(folder.path()), InputError);
    fs::create_directory(folder / "folder.obj");
    EXPECT_THROW(loadMesh(folder / "folder.obj"), InputError);
    for (const char* name : {"mesh.ply", "mesh.stl", "mesh.3ds", "mesh.gltf", "mesh.xyz", "mesh"}) {
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

// The same mesh in each of PLY's formats, cut short anywhere: refused, but for a cut within the very last number of a
// text.
TEST(PlyFile, CutShortAnywhereIsRefused) {
    const test::TemporaryFolder folder;
    const std::string elements =
        " 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    const float places[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::int32_t corners[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const auto append = [](std::string& to, const void* value, std::size_t size, bool big) {
        std::string bytes(static_cast<const char*>(value), size);
        if (big) std::ranges::reverse(bytes);
        to += bytes;
    };
    std::vector<std::string> files = {"ply\nformat ascii" + elements +
                                      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"};
    for (const bool big : {false, true}) {
        std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian" + elements;
        for (const float place : places) append(file, &place, sizeof(place), big);
        for (const auto& face : corners) {
            file += '\3';
            for (const std::int32_t corner : face) append(file, &corner, sizeof(corner), big);
        }
        files.push_back(file);
    }
    for (const std::string& whole : files) {
        const MeshData mesh = loadMesh(folder.write("whole.ply", whole));
        EXPECT_EQ(mesh.triangles.size(), 2U);
        EXPECT_EQ(mesh.positions.size(), 4U);
        const std::size_t shortest = whole.ends_with('\n') ? 2 : 1;
        for (std::size_t size = 0; size + shortest <= whole.size(); ++size)
            EXPECT_THROW(loadMesh(folder.write("cut.ply", whole.substr(0, size))), InputError) << size << " bytes";
    }
}

TEST(PlyFile, WhatItAnnouncesMustMakeSense) {
    const test::TemporaryFolder folder;
    const auto load = [&](const std::string& announced, const std::string& data) {
        return loadMesh(folder.write("bad.ply", "ply\nformat ascii 1.0\n" + announced + "end_header\n" + data));
    };
    const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_EQ(load(vertices + faces, triangle + "3 0 1 2\n").triangles.size(), 1U);
    EXPECT_THROW(load("property float x\n" + vertices + faces, triangle + "3 0 1 2\n"), InputError);
    EXPECT_THROW(load("element vertex -3\n", ""), InputError);
    EXPECT_THROW(load("element vertex many\n", ""), InputError);
    EXPECT_THROW(load("element vertex 1\nproperty colour x\n", "1"), InputError);
    EXPECT_THROW(load(vertices + "element face 1\nproperty list float int vertex_indices\n", triangle + "3 0 1 2\n"),
                 InputError);
    EXPECT_THROW(load(vertices + faces, triangle + "-3 0 1 2\n"), InputError);
    EXPECT_THROW(load(vertices + faces, triangle + "0\n"), InputError) << "a face without corners";
    EXPECT_THROW(load(vertices + faces, triangle + "3 0 1 7\n"), InputError) << "a vertex that isn't there";
}

TEST(ObjFile, ReadsWhatFilesHold) {
    const MeshData mesh =
        parseObj("# all forms of a corner\r\nmtllib nowhere.mtl\r\no thing\r\ng a b\r\ns 1\r\n" + square +
                     "v 0 0 1 1.0\r\nv 1 0 1 0.5 0.25 1\r\nvt 0.5\r\nvt 0.25 0.75\r\nvt 1 2 3\r\nvn 0 0 2\r\n"
                     "usemtl does_not_exist\r\nf 1 2 3\r\nf 1/1 2/2 3/3\r\nf 1//1 2//1 3//1\r\nf 1/1/1 2/2/1 3/3/1\r\n"
                     "f -6 -5 -4\r\nl 1 2\r\np 1\r\ncurv 0 1 1 2\r\nf 1 \\\r\n  2 \\\r\n 3 # here\r\n",
                 "fine.obj");
    EXPECT_EQ(mesh.positions.size(), 6U);
    EXPECT_EQ(mesh.triangles.size(), 6U);
    for (const auto& corners : mesh.triangles) EXPECT_EQ(corners, (MeshData::Corners{0, 1, 2}));
    constexpr std::uint32_t none = MeshData::none;
    EXPECT_EQ(mesh.uvCorners[0], (MeshData::Corners{none, none, none}));
    EXPECT_EQ(mesh.uvCorners[1], (MeshData::Corners{0, 1, 2}));
    EXPECT_EQ(mesh.normalCorners[2], (MeshData::Corners{0, 0, 0}));
    EXPECT_EQ(mesh.normalCorners[1], (MeshData::Corners{none, none, none}));
    EXPECT_EQ(mesh.uvs[0], Vec2(0.5, 0));
    EXPECT_EQ(mesh.uvs[2], Vec2(1, 2));
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 2));
}

TEST(ObjFile, FacesMayComeBeforeTheirVertices) {
    const MeshData mesh = parseObj("f 1 2 3\nf 4 3 2 1\n" + square, "early.obj");
    EXPECT_EQ(mesh.triangles.size(), 3U);
    EXPECT_EQ(mesh.triangles[0], (MeshData::Corners{0, 1, 2}));
}

TEST(ObjFile, LinesMayBeVeryLong) {
    // A face of 6,000 corners, a comb: concave, and refused for its size.
    std::string comb;
    std::string face = "f";
    for (int i = 0; i < 6000; ++i) {
        comb += "v " + std::to_string(i) + (i % 2 == 0 ? " 1 0\n" : " 2 0\n");
        face += " " + std::to_string(i + 1);
    }
    comb += "v 6000 0 0\nv 0 0 0\n";
    EXPECT_THROW(parseObj(comb + face + " 6001 6002\n", "long.obj"), InputError);
    // As triangles of one line each, and with a million blanks between two numbers.
    const std::string noise(1 << 20, ' ');
    EXPECT_NO_THROW(parseObj(square + "f 1" + noise + "2" + noise + "3\n", "spaces.obj"));
    EXPECT_NO_THROW(parseObj("v 0 0 0\n#" + noise + "\n" + "v 1 0 0\nv 0 1 0\nf 1 2 3", "comment.obj"));
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
    for (const char* extension : {".obj", ".ply", ".stl", ".3ds", ".dae"}) {
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
    for (const char* name : {"bunny.obj", "bunny_low.obj"}) files.push_back(test::sourceDir() / "assets/meshes" / name);
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
    for (const BadFile& bad : {badFiles[0], badFiles[10], badFiles[13]}) {
        const fs::path file = folder.write("bad.obj", bad.text);
        const test::MeasuredRun run =
            test::runMeasured({test::chapterProgram(), "--inspect", file.string()}, folder.path());
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
        EXPECT_TRUE(run.output.empty());
    }
}

}  // namespace
}  // namespace caustic
