#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "mesh/mesh_file.h"
#include "mesh/obj_file.h"
#include "mesh/ply_file.h"
#include "mesh/stl_file.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

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

struct BadMesh {
    std::string name;
    std::string text;
    std::string said;  // a part of the message
};

std::string ply(const std::string& announced, const std::string& data) {
    return "ply\nformat ascii 1.0\n" + announced + "end_header\n" + data;
}

const std::string plyVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string plyFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string plyPlaces = "0 0 0\n1 0 0\n0 1 0\n";
const std::string stlHead = "solid a\nfacet normal 0 0 1\nouter loop\n";
const std::string stlTail = "endloop\nendfacet\nendsolid a\n";
const std::string stlCorners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

const std::vector<BadMesh> badPly = {
    {"other format", "ply\nformat ascii7 1.0\nend_header\n", "bad.ply:2: is no format"},
    {"no format", "ply\nelement vertex 0\nend_header\n", "no format line"},
    {"no magic", "plywood\nformat ascii 1.0\nend_header\n", "first line is not ply"},
    {"lone CR", "ply\rformat ascii 1.0\rend_header\r", "CR alone"},
    {"unknown statement", ply("elements vertex 3\n", ""), "bad.ply:3: is no statement"},
    {"element twice", ply(plyVertices + plyVertices, ""), "comes twice"},
    {"property twice", ply("element vertex 1\nproperty float x\nproperty int x\n", ""),
     "bad.ply:5: is a property that"},
    {"no z", ply("element vertex 1\nproperty float x\nproperty float y\n" + plyFace, "0 0\n3 0 0 0\n"), "x, y and z"},
    {"a list for x",
     ply("element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float z\n", "1 0 0 0"),
     "x, y and z"},
    {"no list of corners", ply(plyVertices + "element face 1\nproperty int vertex_indices\n", plyPlaces + "0"),
     "needs a list of integers"},
    {"corners as floats",
     ply(plyVertices + "element face 1\nproperty list uchar float vertex_indices\n", plyPlaces + "3 0 1 2"),
     "needs a list of integers"},
    {"no faces", ply(plyVertices, plyPlaces), "has no face"},
    {"NaN", ply(plyVertices + plyFace, "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
     "bad.ply:11: vertex 1: must be finite (got 'nan')"},
    {"too large", ply(plyVertices + plyFace, "0 0 0\n1 1e999 0\n0 1 0\n3 0 1 2\n"),
     "vertex 1: must be a number (got '1e999')"},
    {"rubbish", ply(plyVertices + plyFace, "0 0 0\n1 0 0\n0 1 z\n3 0 1 2\n"),
     "bad.ply:12: vertex 2: must be a number (got 'z')"},
    {"a fraction of a corner", ply(plyVertices + plyFace, plyPlaces + "3 0 1 1.5\n"),
     "bad.ply:13: face 0: must be an integer"},
    {"no such vertex", ply(plyVertices + plyFace, plyPlaces + "3 0 1 3\n"),
     "bad.ply:13: face 0: names a vertex that isn't there; there are 3 (got '3')"},
    {"negative corner", ply(plyVertices + plyFace, plyPlaces + "3 0 1 -1\n"), "names a vertex that isn't there"},
    {"two corners", ply(plyVertices + plyFace, plyPlaces + "2 0 1\n"), "a face needs at least three (got '2 corners')"},
    {"more than announced", ply(plyVertices + plyFace, plyPlaces + "3 0 1 2\n3 0 1 2\n"), "bad.ply:14: is more than"},
    {"fewer than announced", ply(plyVertices + plyFace, plyPlaces), "face 0"},
    {"a list without end",
     ply(plyVertices + "element face 1\nproperty list uint int vertex_indices\n", plyPlaces + "4000000000 0"),
     "cut short"},
    {"vertices without end",
     ply("element vertex 1000000000000000\nproperty float x\nproperty float y\nproperty float z\n", "1"), "cut short"},
    {"nothings without end", ply("element nothing 1000000000000000\n" + plyVertices, plyPlaces), "has no face"},
};

const std::vector<BadMesh> badStl = {
    {"empty", "", "only its beginning"},
    {"no STL", std::string(200, 'x'), "facets that it announces"},
    {"no facet", "solid a\nendsolid a\n", "has no facet"},
    {"cut short", stlHead + stlCorners, "bad.stl:7: ends before its endsolid"},
    {"a square", stlHead + stlCorners + "vertex 0 0 1\n" + stlTail, "bad.stl:7: must be endloop (got 'vertex')"},
    {"two corners", stlHead + "vertex 0 0 0\nvertex 1 0 0\n" + stlTail, "bad.stl:6: must be vertex (got 'endloop')"},
    {"NaN", stlHead + "vertex 0 0 0\nvertex nan 0 0\nvertex 0 1 0\n" + stlTail, "bad.stl:5: must be finite"},
    {"rubbish", stlHead + "vertex 0 0 0\nvertex 1 0 a\nvertex 0 1 0\n" + stlTail,
     "bad.stl:5: must be a number (got 'a')"},
    {"rubbish after it", stlHead + stlCorners + stlTail + "more", "must be solid (got 'more')"},
};

template <typename Parse>
void expectRefused(const std::vector<BadMesh>& files, const std::string& file, Parse parse) {
    for (const BadMesh& bad : files) {
        try {
            parse(bad.text, file);
            ADD_FAILURE() << bad.name << " was accepted";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(bad.said), std::string::npos) << bad.name << ": " << error.what();
        }
    }
}

TEST(PlyFile, EachFaultIsNamed) { expectRefused(badPly, "bad.ply", parsePly); }
TEST(StlFile, EachFaultIsNamed) { expectRefused(badStl, "bad.stl", parseStl); }

TEST(StlFile, BinaryCutShortOrTooLongIsRefused) {
    const MeshData mesh = parseObj(test::objOf(test::lPrism(1)), "twin.obj");
    for (const char* header : {"", "solid but binary"}) {
        const std::string whole = test::stlBinaryOf(mesh, header);
        EXPECT_EQ(parseStl(whole, "whole.stl").triangles.size(), mesh.triangles.size());
        for (std::size_t size = 0; size < whole.size(); ++size)
            EXPECT_THROW(parseStl(whole.substr(0, size), "cut.stl"), InputError) << size;
        EXPECT_THROW(parseStl(whole + "x", "long.stl"), InputError);
    }
    MeshData bad = mesh;
    bad.positions[3].y() = std::numeric_limits<Real>::infinity();
    EXPECT_THROW(parseStl(test::stlBinaryOf(bad, ""), "infinite.stl"), InputError);
}

TEST(StlFile, TextCutShortAnywhereIsRefused) {
    const std::string whole = stlHead + stlCorners + stlTail;
    ASSERT_EQ(parseStl(whole, "whole.stl").triangles.size(), 1U);
    const std::size_t shortest = whole.find("endsolid") + 8;
    for (std::size_t size = 0; size < shortest; ++size)
        EXPECT_THROW(parseStl(whole.substr(0, size), "cut.stl"), InputError) << size;
}

}  // namespace
}  // namespace caustic
