#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "mesh/obj_file.h"

namespace caustic {
namespace {

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
    {"lone CR", "# old\rv 0 0 0\rv 1 0 0\r", 1, ""},
    {"lone CR among others", "v 0 0 0\n# a\rv 1 0 0\nv 0 1 0\n", 2, ""},
    {"plus and minus", "v 0 0 +-1\n", 1, "+-1"},
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

// A comment and a name may end in a backslash, as paths do; only a statement goes on after one.
TEST(ObjFile, BackslashesBelongToWhatTheyEnd) {
    const auto triangles = [](const std::string& text) { return parseObj(square + text, "back.obj").triangles.size(); };
    EXPECT_EQ(triangles("# D:\\out\\\nf 1 2 3\n"), 1U);
    EXPECT_EQ(triangles("usemtl lib\\steel\\\nf 1 2 3\nf 1 2 4\n"), 2U);
    EXPECT_EQ(triangles("mtllib c:\\\ng a\\\no b\\\ns c\\\nf 1 2 3\n"), 1U);
    EXPECT_EQ(triangles("f 1 2 3 # see D:\\\nf 1 2 4\n"), 2U);
    EXPECT_EQ(triangles("f 1 \\  # goes on\r\n 2 \\\n\\\n3 # ends \\\nf 1 2 4\n"), 2U);
    EXPECT_EQ(triangles("curv 0 1 \\\n 1 2\nf 1 2 3"), 1U);
}

TEST(ObjFile, NumbersTooSmallAreZero) {
    const MeshData mesh = parseObj("v 0 0 -1e-400\nv 1 0 0.000001e-330\nv 0 1e-310 4e-324\nf 1 2 3\r\r\n", "tiny.obj");
    EXPECT_EQ(mesh.positions[0].z(), 0);
    EXPECT_EQ(mesh.positions[1].z(), 0);
    EXPECT_EQ(mesh.positions[2], Vec3(0, 1e-310, 4e-324)) << "what a double holds it keeps";
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

}  // namespace
}  // namespace caustic
