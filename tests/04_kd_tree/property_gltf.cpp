#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "mesh/gltf_file.h"
#include "mesh/obj_file.h"
#include "support/gltf_writer.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

using Json = nlohmann::json;
using test::GltfWriter;
using test::volumeOf;

std::vector<Real> flat(const std::vector<Vec3>& vectors) {
    std::vector<Real> values;
    for (const Vec3& v : vectors) values.insert(values.end(), v.begin(), v.end());
    return values;
}

std::vector<Real> flatIndices(const MeshData& mesh) {
    std::vector<Real> values;
    for (const auto& corners : mesh.triangles) values.insert(values.end(), corners.begin(), corners.end());
    return values;
}

MeshData twinOf(Real scale) { return parseObj(test::objOf(test::lPrism(scale)), "twin.obj"); }

GltfWriter writerOf(const MeshData& mesh) {
    GltfWriter writer;
    const int positions = writer.add(flat(mesh.positions), 3, "float");
    writer.addPrimitive({{"POSITION", positions}}, writer.add(flatIndices(mesh), 1, "ushort"));
    return writer;
}

MeshData parse(const GltfWriter& writer) { return parseGltf(writer.text(), "test.gltf"); }

void expectTwins(const MeshData& mesh, const MeshData& twin, const std::string& what) {
    ASSERT_EQ(mesh.triangles.size(), twin.triangles.size()) << what;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) ASSERT_EQ(mesh.corners(i), twin.corners(i)) << what;
}

TEST(ObjTwins, OfGltfAgreeToTheLastBitAtAnyScale) {
    for (const Real scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        const MeshData twin = twinOf(scale);
        const GltfWriter writer = writerOf(twin);
        expectTwins(parse(writer), twin, "text");
        expectTwins(parseGltf(writer.binary(), "test.glb"), twin, "binary");
        EXPECT_NEAR(volumeOf(parse(writer)) / std::pow(scale, 3), 20, 1e-5);
        EXPECT_NEAR(test::areaOf(parse(writer)) / std::pow(scale, 2), 58, 1e-5);
    }
}

TEST(ObjTwins, OfGltfWithStridesAndAnyIndicesAgreeToTheLastBit) {
    const MeshData twin = twinOf(1);
    for (const char* type : {"uchar", "ushort", "uint"}) {
        for (const std::size_t stride : {0U, 12U, 16U, 40U}) {
            GltfWriter writer;
            const int positions = writer.add(flat(twin.positions), 3, "float", false, stride);
            writer.addPrimitive({{"POSITION", positions}}, writer.add(flatIndices(twin), 1, type));
            expectTwins(parse(writer), twin, type + std::to_string(stride));
        }
    }
    // Without indices, each corner on its own.
    GltfWriter writer;
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < twin.triangles.size(); ++i) {
        for (const Vec3& corner : twin.corners(i)) corners.push_back(corner);
    }
    writer.addPrimitive({{"POSITION", writer.add(flat(corners), 3, "float")}}, -1);
    expectTwins(parse(writer), twin, "no indices");
}

TEST(GltfFile, SparseValuesReplaceThoseOfTheViewOrZeros) {
    const MeshData twin = twinOf(1);
    for (const bool withView : {true, false}) {
        std::vector<Vec3> base(twin.positions.size(), withView ? Vec3(9, 9, 9) : Vec3(0, 0, 0));
        std::vector<Real> indices;
        std::vector<Real> values;
        for (std::size_t i = 0; i < base.size(); ++i) {
            if (withView && i % 2 == 0) {
                base[i] = twin.positions[i];
            } else {
                indices.push_back(static_cast<Real>(i));
                values.insert(values.end(), twin.positions[i].begin(), twin.positions[i].end());
            }
        }
        GltfWriter writer;
        const int positions = writer.add(flat(base), 3, "float");
        const int at = writer.add(indices, 1, "uchar");
        const int what = writer.add(values, 3, "float");
        Json& accessor = writer.json["accessors"][0];
        const auto view = [&](int number) {
            return writer.json["accessors"][static_cast<std::size_t>(number)]["bufferView"];
        };
        accessor["sparse"] = {{"count", indices.size()},
                              {"indices", {{"bufferView", view(at)}, {"componentType", 5121}}},
                              {"values", {{"bufferView", view(what)}}}};
        if (!withView) accessor.erase("bufferView");
        writer.addPrimitive({{"POSITION", positions}}, writer.add(flatIndices(twin), 1, "ushort"));
        expectTwins(parse(writer), twin, withView ? "over a view" : "over zeros");
    }
}

// Khronos 2021, 3.7.2.1: the triangles of a strip and of a fan.
TEST(GltfFile, StripsAndFansKeepTheirOutside) {
    const std::vector<Vec3> zigzag = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
    GltfWriter strip;
    strip.addPrimitive({{"POSITION", strip.add(flat(zigzag), 3, "float")}}, -1, 5);
    const MeshData four = parse(strip);
    ASSERT_EQ(four.triangles.size(), 4U);
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(twiceArea(four, i), Vec3(0, 0, 1)) << i;

    const std::vector<Vec3> hexagon = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}, {-1, 1, 0}};
    GltfWriter fan;
    fan.addPrimitive({{"POSITION", fan.add(flat(hexagon), 3, "float")}}, fan.add({0, 1, 2, 3, 4, 5}, 1, "uchar"), 6);
    const MeshData fanned = parse(fan);
    ASSERT_EQ(fanned.triangles.size(), 4U);
    Real area = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_GT(twiceArea(fanned, i).z(), 0) << i;
        area += twiceArea(fanned, i).z() / 2;
    }
    EXPECT_EQ(area, 6);

    GltfWriter mixed = strip;
    mixed.addPrimitive({{"POSITION", 0}}, -1, 0);
    mixed.addPrimitive({{"POSITION", 0}}, -1, 3);
    EXPECT_EQ(parse(mixed).triangles.size(), 4U) << "points and lines have no triangles";
}

// 3.11: c / 127 for signed bytes and so on; without normalisation the integers themselves.
TEST(GltfFile, QuantisedAttributesAreDecoded) {
    struct Case {
        const char* type;
        Real largest;
        Real least;
    };
    for (const auto& [type, largest, least] :
         {Case{"char", 127, -128}, Case{"uchar", 255, 0}, Case{"short", 32767, -32768}, Case{"ushort", 65535, 0}}) {
        for (const bool normalized : {true, false}) {
            GltfWriter writer;
            const std::vector<Real> corners = {largest, 0, 0, 0, largest, 1, least, 0, largest};
            const std::vector<Real> uvs = {0, largest, largest, 0, 0, 0};
            writer.addPrimitive({{"POSITION", writer.add(corners, 3, type, normalized, 12)},
                                 {"NORMAL", writer.add(corners, 3, type, true, 12)},
                                 {"TEXCOORD_0", writer.add(uvs, 2, type, true, 8)}},
                                -1);
            const MeshData mesh = parse(writer);
            const Real one = normalized ? 1 : largest;
            EXPECT_EQ(mesh.positions[0], Vec3(one, 0, 0)) << type;
            EXPECT_EQ(mesh.positions[1], Vec3(0, one, normalized ? 1 / largest : 1)) << type;
            EXPECT_EQ(mesh.positions[2].x(), normalized ? (least < 0 ? -1 : 0) : least) << type;
            EXPECT_EQ(mesh.normals[0], Vec3(1, 0, 0)) << type;
            EXPECT_EQ(mesh.uvs[0], Vec2(0, 0)) << "v points up here, down there";
            EXPECT_EQ(mesh.uvs[1], Vec2(1, 1)) << type;
        }
    }
}

// The node's own matrix, written down by the quaternion's formula.
Eigen::Matrix3d rotationOf(const Eigen::Vector4d& q) {
    const auto [x, y, z, w] = std::array{q[0], q[1], q[2], q[3]};
    Eigen::Matrix3d m;
    m << 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),   //
        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y);
    return m;
}

TEST(GltfFile, NodesMoveAndMirrorWithoutTurningInsideOut) {
    const MeshData twin = twinOf(1);
    const Eigen::Vector4d q = Eigen::Vector4d(0.1, -0.7, 0.2, 0.5).normalized();
    for (const Vec3& scale : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(2, -3, 0.5), Vec3(-1, -2, -3), Vec3(-1, 1, -1)}) {
        GltfWriter writer = writerOf(twin);
        std::vector<Real> normals;
        for (std::size_t i = 0; i < twin.positions.size(); ++i) normals.insert(normals.end(), {0.5, -1, 2});
        const int normal = writer.add(normals, 3, "float");
        writer.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normal;
        writer.json["nodes"] = {
            {{"children", {1}}, {"translation", {5, 6, 7}}},
            {{"mesh", 0}, {"rotation", {q[0], q[1], q[2], q[3]}}, {"scale", {scale.x(), scale.y(), scale.z()}}}};
        const MeshData mesh = parse(writer);
        const Real expected = 20 * std::abs(scale.prod());
        EXPECT_NEAR(volumeOf(mesh), expected, 1e-5 * expected)
            << scale.transpose() << ": is the outside still outside?";
        const Eigen::Matrix3d linear = rotationOf(q) * scale.asDiagonal();
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_LE((mesh.positions[i] - (linear * twin.positions[i] + Vec3(5, 6, 7))).norm(), 1e-12);
        }
        const Vec3 wanted = (linear.inverse().transpose() * Vec3(0.5, -1, 2)).normalized();
        EXPECT_LE((mesh.normals[0].normalized() - wanted).norm(), 1e-12) << scale.transpose();

        // The same transform as a matrix, by columns.
        Json matrix = Json::array();
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                const bool inner = row < 3 && column < 3;
                const Vec3 shift(5, 6, 7);
                matrix.push_back(inner ? linear(row, column) : row == 3 ? Real(column == 3) : shift[row]);
            }
        }
        writer.json["nodes"] = {{{"mesh", 0}, {"matrix", matrix}}};
        const MeshData same = parse(writer);
        ASSERT_EQ(same.triangles, mesh.triangles);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            EXPECT_LE((same.positions[i] - mesh.positions[i]).norm(), 1e-12);
    }
}

TEST(GltfFile, AMeshMayBeShownTwice) {
    GltfWriter writer = writerOf(twinOf(1));
    writer.json["scenes"][0]["nodes"] = {1, 0};
    writer.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {10, 0, 0}}}, {{"mesh", 0}}};
    const MeshData mesh = parse(writer);
    EXPECT_EQ(mesh.positions.size(), 24U) << "the third is not in the scene";
    EXPECT_NEAR(volumeOf(mesh), 40, 1e-5);
}

TEST(GltfFile, BuffersMayLieBesideIt) {
    const test::TemporaryFolder folder;
    const MeshData twin = twinOf(1);
    GltfWriter writer = writerOf(twin);
    const std::string glb = writer.binary();
    const std::size_t size = Json::parse(writer.text())["buffers"][0]["byteLength"];
    folder.write("shape data.bin", glb.substr(glb.size() - (size + 3) / 4 * 4, size));
    writer.json["buffers"] = Json::array({{{"byteLength", size}, {"uri", "shape%20data.bin"}}});
    expectTwins(parseGltf(writer.text(), folder / "test.gltf"), twin, "beside it");
    folder.write("shape data.bin", "short");
    EXPECT_THROW(parseGltf(writer.text(), folder / "test.gltf"), InputError);
    writer.json["buffers"][0]["uri"] = "missing.bin";
    EXPECT_THROW(parseGltf(writer.text(), folder / "test.gltf"), InputError);
}

}  // namespace
}  // namespace caustic
