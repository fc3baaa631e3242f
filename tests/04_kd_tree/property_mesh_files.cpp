#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/text.h"
#include "mesh/mesh_file.h"
#include "mesh/obj_file.h"
#include "mesh/ply_file.h"
#include "mesh/stl_file.h"
#include "support/mesh_files.h"
#include "support/paths.h"

namespace caustic {
namespace {

using test::areaOf;
using test::PlyStyle;
using test::volumeOf;
using Format = test::PlyStyle::Format;

const std::vector<Real> scales = {1e-6, 1e-3, 0.7, 1, 1e3, 1e6};

// The corners of all triangles, place by place: the same to the last bit, in the same order.
void expectTwins(const MeshData& mesh, const MeshData& twin, const std::string& what) {
    ASSERT_EQ(mesh.triangles.size(), twin.triangles.size()) << what;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) ASSERT_EQ(mesh.corners(i), twin.corners(i)) << what;
}

// Twenty cubes and 58 squares of size scale, whatever the reader: floats are off by 6e-8 each.
void expectBody(const MeshData& mesh, Real scale, const std::string& what) {
    EXPECT_NEAR(volumeOf(mesh) / std::pow(scale, 3), 20, 1e-5) << what;
    EXPECT_NEAR(areaOf(mesh) / std::pow(scale, 2), 58, 1e-5) << what;
    EXPECT_EQ(unusedVertices(mesh), 0U) << what;
    EXPECT_EQ(mesh.positions.size(), 12U) << what;
}

TEST(ObjTwins, OfPlyInEverySpellingAgreeToTheLastBit) {
    for (const Real scale : scales) {
        const test::Polyhedron body = test::lPrism(scale);
        const MeshData twin = parseObj(test::objOf(body), "twin.obj");
        expectBody(twin, scale, "OBJ");
        int files = 0;
        for (const Format format : {Format::Text, Format::Little, Format::Big}) {
            for (const char* coordinate : {"float", "double"}) {
                for (const char* index : {"char", "uchar", "short", "ushort", "int", "uint"}) {
                    const bool odd = ++files % 2 == 1;
                    const PlyStyle style = {format,        coordinate,          odd ? "uchar" : "int",
                                            index,         odd ? "zxy" : "yzx", files % 3 == 0,
                                            files % 5 == 0};
                    const std::string what = "PLY " + std::to_string(files) + ", scale " + formatReal(scale);
                    const MeshData mesh = parsePly(test::plyOf(body, style), "body.ply");
                    expectTwins(mesh, twin, what);
                    expectBody(mesh, scale, what);
                }
            }
        }
    }
}

// Doubles that no float holds come through whole, in text whatever type the header announces.
TEST(ObjTwins, OfPlyInDoublePrecisionKeepAllDigits) {
    test::Polyhedron body = test::lPrism(1);
    for (Vec3& vertex : body.vertices) vertex = vertex * (1 + 1e-12) + Vec3(1e5, 0, 0) / 3;
    const MeshData twin = parseObj(test::objOf(body), "twin.obj");
    expectTwins(parsePly(test::plyOf(body, {Format::Little, "double"}), "a.ply"), twin, "little endian");
    expectTwins(parsePly(test::plyOf(body, {Format::Big, "double"}), "b.ply"), twin, "big endian");
    expectTwins(parsePly(test::plyOf(body, {Format::Text, "float"}), "c.ply"), twin, "text");
}

TEST(ObjTwins, OfStlAgreeToTheLastBit) {
    for (const Real scale : scales) {
        const MeshData twin = parseObj(test::objOf(test::lPrism(scale)), "twin.obj");
        // A binary file may call itself solid, and a text be named like a keyword.
        for (const std::string name : {"", "solid", "solid facet normal vertex endsolid", "exported by hand"}) {
            const MeshData binary = parseStl(test::stlBinaryOf(twin, name), "binary.stl");
            expectTwins(binary, twin, "binary " + name);
            expectBody(binary, scale, "binary " + name);
            const MeshData text = parseStl(test::stlTextOf(twin, name), "text.stl");
            expectTwins(text, twin, "text " + name);
            expectBody(text, scale, "text " + name);
        }
    }
}

TEST(StlFile, SolidsCapitalsAndLineEndsMakeNoDifference) {
    const MeshData twin = parseObj(test::objOf(test::lPrism(1)), "twin.obj");
    std::string text = test::stlTextOf(twin, "A");
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string copy = text;
        for (std::size_t at = copy.find(from); at != std::string::npos; at = copy.find(from, at + to.size()))
            copy.replace(at, from.size(), to);
        return copy;
    };
    expectTwins(parseStl(replaced("\n", "\r\n"), "crlf.stl"), twin, "CR LF");
    expectTwins(parseStl(replaced("\n", "\r"), "cr.stl"), twin, "CR");
    expectTwins(parseStl(replaced("vertex", "VERTEX"), "capitals.stl"), twin, "capitals");
    expectTwins(parseStl(replaced("normal 0 0 0", "normal nan -nan inf"), "normals.stl"), twin, "normals");
    const MeshData two = parseStl(text + text, "two.stl");
    EXPECT_EQ(two.triangles.size(), 2 * twin.triangles.size());
    EXPECT_NEAR(volumeOf(two), 40, 1e-5);
}

// Corners at one place become one vertex, however small the mesh; others never do.
TEST(StlFile, OnlyEqualPlacesAreJoined) {
    MeshData thin;
    thin.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-38}, {1, 0, 1e-38}, {-0.0, 1, -0.0}};
    thin.triangles = {{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(parseStl(test::stlBinaryOf(thin, ""), "thin.stl").positions.size(), 5U);
    EXPECT_EQ(parseStl(test::stlTextOf(thin, ""), "thin.stl").positions.size(), 5U);
}

// Turn about: every other triangle of a strip goes round the other way.
TEST(PlyFile, StripsAndNormalsAndTextureCoordinates) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float nx\nproperty float x\nproperty float "
        "y\nproperty float z\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n";
    std::string vertices;
    for (int i = 0; i < 6; ++i) {
        vertices +=
            "0.25 " + std::to_string(i / 2) + " " + std::to_string(i % 2) + " 0 0.5 1 " + std::to_string(i) + " -1\n";
    }
    const MeshData mesh = parsePly(head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                                       vertices + "13 0 2 1 3 -1 2 4 3 5 5 5 -1 0\n",
                                   "strips.ply");
    const std::vector<MeshData::Corners> expected = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
    EXPECT_EQ(mesh.triangles, expected);
    EXPECT_EQ(mesh.normalCorners, expected);
    EXPECT_EQ(mesh.uvCorners, expected);
    EXPECT_EQ(mesh.normals[3], Vec3(0.25, 0.5, 1));
    EXPECT_EQ(mesh.uvs[4], Vec2(4, -1));
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(twiceArea(mesh, i), Vec3(0, 0, 1)) << "all face the same way";
}

TEST(PlyFile, FacesMayComeBeforeTheirVertices) {
    const MeshData mesh = parsePly(
        "ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty list uchar int vertex_index\r\nelement vertex 4\r\n"
        "property double z\r\nproperty double y\r\nproperty double x\r\nend_header\r\n4 0 1 2 3\r\n"
        "0 0 0\r\n0 0 1\r\n0 1 1\r\n1e-400 1 0\r\n",
        "early.ply");
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.positions[3], Vec3(0, 1, 0));
}

MeshData field(const std::string& name) { return loadMesh(test::sourceDir() / "tests/04_kd_tree/field" / name); }

// Files as other programs write them, with what is known of the bodies in them.
TEST(FromTheField, MeshesAreReadRight) {
    EXPECT_NEAR(volumeOf(field("data_begins_0a.ply")), Real(1) / 6, 1e-6);
    EXPECT_NEAR(volumeOf(field("tristrips.ply")), Real(1) / 6, 1e-15);
    EXPECT_EQ(field("tristrips.ply").triangles.size(), 4U);
    const MeshData plate = field("thin_plate.ply");
    EXPECT_EQ(plate.positions.size(), 8U);
    EXPECT_NEAR(volumeOf(plate), 4e-6, 1e-20);

    EXPECT_EQ(field("underflow.obj").positions[1], Vec3(1, 0, 0));
    EXPECT_EQ(field("backslash_ends_name.obj").triangles.size(), 4U);
    const MeshData stray = field("stray_vertex.obj");
    EXPECT_EQ(boundsOf(stray).max(), Vec3(1, 1, 1));
    EXPECT_EQ(boundsOf(stray).min(), Vec3(0, 0, 0));
    EXPECT_EQ(unusedVertices(stray), 1U);

    const MeshData mirrored = field("mirrored_node.gltf");
    EXPECT_NEAR(volumeOf(mirrored), Real(1) / 6, 1e-15);
    EXPECT_EQ(boundsOf(mirrored).min(), Vec3(-1, 0, 0));
    const MeshData sphere = field("quantized.gltf");
    EXPECT_NEAR(volumeOf(sphere), 0.49776, 1e-5);
    EXPECT_LE(boundsOf(sphere).min().cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LE((boundsOf(sphere).max() - Vec3::Ones()).cwiseAbs().maxCoeff(), 1e-4);
}

}  // namespace
}  // namespace caustic
