#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "mesh/gltf_file.h"
#include "mesh/mesh_file.h"
#include "support/gltf_writer.h"
#include "support/paths.h"

namespace caustic {
namespace {

using Json = nlohmann::json;
using test::GltfWriter;

GltfWriter tetrahedron() {
    GltfWriter writer;
    const int positions = writer.add({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3, "float");
    writer.addPrimitive({{"POSITION", positions}}, writer.add({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 1, "ushort"));
    return writer;
}

std::string messageOf(const std::function<MeshData()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string messageOf(const GltfWriter& writer) {
    return messageOf([&] { return parseGltf(writer.text(), "bad.gltf"); });
}

struct Fault {
    const char* name;
    std::function<void(Json&)> make;
    const char* said;
};

// Each changes one thing of a file that is fine; a part of what must be said about it.
const std::vector<Fault> faults = {
    {"index of no vertex", [](Json& j) { j["accessors"][0]["count"] = 3; },
     "accessor 1 has an index that names no vertex"},
    {"view too short", [](Json& j) { j["bufferViews"][0]["byteLength"] = 47; },
     "accessor 0 ends after its buffer view"},
    {"view after the buffer", [](Json& j) { j["bufferViews"][1]["byteOffset"] = 50; }, "buffer view that ends after"},
    {"huge view", [](Json& j) { j["bufferViews"][1]["byteLength"] = 4000000000U; }, "buffer view that ends after"},
    {"offset after the view", [](Json& j) { j["accessors"][0]["byteOffset"] = 4; }, "accessor 0 ends after"},
    {"count beyond the view", [](Json& j) { j["accessors"][1]["count"] = 13; }, "accessor 1 ends after"},
    {"huge count", [](Json& j) { j["accessors"][1]["count"] = 4000000000U; }, "accessor 1 ends after"},
    {"stride too short", [](Json& j) { j["bufferViews"][0]["byteStride"] = 4; }, "stride"},
    {"no such view", [](Json& j) { j["accessors"][0]["bufferView"] = 7; }, "buffer view that isn't there"},
    {"no such buffer", [](Json& j) { j["bufferViews"][0]["buffer"] = 7; }, "buffer that isn't there"},
    {"no such accessor", [](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 7; }, "accessor 7"},
    {"no such indices", [](Json& j) { j["meshes"][0]["primitives"][0]["indices"] = 7; }, "accessor"},
    {"no such mesh", [](Json& j) { j["nodes"][0]["mesh"] = 7; }, "mesh 7"},
    {"no such node", [](Json& j) { j["scenes"][0]["nodes"] = {7}; }, "node 7"},
    {"no such scene", [](Json& j) { j["scene"] = 7; }, "scene 7"},
    {"no scene", [](Json& j) { j.erase("scenes"); }, "scene"},
    {"a circle of nodes", [](Json& j) { j["nodes"][0]["children"] = {0}; }, "reached twice"},
    {"a node with two parents",
     [](Json& j) {
         j["scenes"][0]["nodes"] = {0, 0};
     },
     "reached twice"},
    {"unknown component type", [](Json& j) { j["accessors"][0]["componentType"] = 5130; }, ""},
    {"positions of two", [](Json& j) { j["accessors"][0]["type"] = "VEC2"; }, "must have 3 components"},
    {"no positions",
     [](Json& j) {
         j["meshes"][0]["primitives"][0]["attributes"] = {{"NORMAL", 0}};
     },
     "POSITION"},
    {"uvs that are too few", [](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 1; }, ""},
    {"mode of no kind", [](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 7; }, "mode"},
    {"eleven indices", [](Json& j) { j["accessors"][1]["count"] = 11; }, "three for each triangle"},
    {"points alone", [](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 0; }, "no triangle"},
    {"version 1", [](Json& j) { j["asset"]["version"] = "1.0"; }, "version 2"},
    {"no version", [](Json& j) { j.erase("asset"); }, ""},
    {"unknown extension", [](Json& j) { j["extensionsRequired"] = {"EXT_any"}; }, "EXT_any"},
    {"compression", [](Json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
     "KHR_draco_mesh_compression"},
    {"a skin", [](Json& j) { j["nodes"][0]["skin"] = 0; }, "skin"},
    {"morph weights", [](Json& j) { j["meshes"][0]["weights"] = {0.5}; }, "morph"},
    {"instances",
     [](Json& j) {
         j["nodes"][0]["extensions"] = {{"EXT_mesh_gpu_instancing", {{"attributes", Json::object()}}}};
     },
     "EXT_mesh_gpu_instancing"},
    {"a perspective matrix",
     [](Json& j) { j["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }, "not affine"},
    {"a matrix of 12", [](Json& j) { j["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}; },
     "a matrix of 12 numbers"},
    {"a translation of 2",
     [](Json& j) {
         j["nodes"][0]["translation"] = {1.5, 2};
     },
     "a translation of 2 numbers"},
    {"a rotation of 3",
     [](Json& j) {
         j["nodes"][0]["rotation"] = {0.5, 0.5, 0.5};
     },
     "a rotation of 3 numbers"},
    {"a scale of 1", [](Json& j) { j["nodes"][0]["scale"] = {-1}; }, "a scale of 1 numbers"},
    {"a scale of 4",
     [](Json& j) {
         j["nodes"][0]["scale"] = {1, 2, 3, 4};
     },
     "a scale of 4 numbers"},
    {"buffer of another size",
     [](Json& j) {
         j["buffers"] = {{{"byteLength", 99}, {"uri", "data:application/octet-stream;base64,AAAA"}}};
     },
     ""},
    {"buffer without bytes",
     [](Json& j) {
         j["buffers"] = {{{"byteLength", 0}, {"uri", "data:application/octet-stream;base64,"}}};
     },
     ""},
    {"a buffer that is no file",
     [](Json& j) {
         j["buffers"] = {{{"byteLength", 72}, {"uri", "nowhere.bin"}}};
     },
     "nowhere.bin"},
    {"many zeros",
     [](Json& j) {
         j["accessors"][0].erase("bufferView");
         j["accessors"][0]["count"] = 4000000000U;
     },
     "zeros"},
    {"sparse index of no element",
     [](Json& j) {
         j["accessors"][0]["sparse"] = {{"count", 2},
                                        {"indices", {{"bufferView", 1}, {"byteOffset", 2}, {"componentType", 5125}}},
                                        {"values", {{"bufferView", 0}}}};
     },
     "sparse index"},
    {"more sparse values than values",
     [](Json& j) {
         j["accessors"][0]["sparse"] = {
             {"count", 5}, {"indices", {{"bufferView", 1}, {"componentType", 5123}}}, {"values", {{"bufferView", 0}}}};
     },
     "sparse"},
};

TEST(GltfFile, EachFaultIsRefusedInOneLineThatNamesIt) {
    ASSERT_EQ(messageOf(tetrahedron()), "no error");
    for (const Fault& fault : faults) {
        GltfWriter writer = tetrahedron();
        fault.make(writer.json);
        const std::string message = messageOf(writer);
        EXPECT_TRUE(message.starts_with("bad.gltf")) << fault.name << ": " << message;
        EXPECT_NE(message.find(fault.said), std::string::npos) << fault.name << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << fault.name << ": " << message;
    }
}

TEST(GltfFile, ExtensionsWithoutShapeMayBeRequired) {
    for (const char* name :
         {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform", "KHR_lights_punctual"}) {
        GltfWriter writer = tetrahedron();
        writer.json["extensionsRequired"] = {name};
        EXPECT_EQ(messageOf(writer), "no error") << name;
    }
}

TEST(GltfFile, CoordinatesMustBeFinite) {
    GltfWriter writer;
    const Real inf = std::numeric_limits<Real>::infinity();
    writer.addPrimitive({{"POSITION", writer.add({0, 0, 0, 1, inf, 0, 0, 1, 0}, 3, "float")}}, -1);
    EXPECT_EQ(messageOf(writer), "bad.gltf: accessor 0 must have finite values (got 'inf')");
}

TEST(GltfFile, CutShortAnywhereIsRefused) {
    const std::string text = tetrahedron().text();
    const std::string binary = tetrahedron().binary();
    for (std::size_t size = 0; size < text.size(); ++size)
        EXPECT_NE(messageOf([&] { return parseGltf(text.substr(0, size), "bad.gltf"); }), "no error") << size;
    for (std::size_t size = 0; size < binary.size(); ++size)
        EXPECT_NE(messageOf([&] { return parseGltf(binary.substr(0, size), "bad.glb"); }), "no error") << size;
}

// A chunk that claims to end up to 8 bytes after the file, which tinygltf 2.7 believes.
TEST(GltfFile, ChunksMustEndWithTheFile) {
    std::string binary = tetrahedron().binary();
    const auto jsonSize = static_cast<std::size_t>(static_cast<unsigned char>(binary[12])) +
                          256 * static_cast<std::size_t>(static_cast<unsigned char>(binary[13]));
    binary[20 + jsonSize] = static_cast<char>(binary[20 + jsonSize] + 8);
    EXPECT_EQ(messageOf([&] { return parseGltf(binary, "bad.glb"); }), "bad.glb: has a chunk that ends after the file");
}

TEST(GltfFile, DeepJsonIsRefusedBeforeItFillsTheStack) {
    GltfWriter writer = tetrahedron();
    std::string text = writer.text();
    text.insert(1, "\"extras\":" + std::string(1000000, '[') + std::string(1000000, ']') + ",");
    EXPECT_EQ(messageOf([&] { return parseGltf(text, "bad.gltf"); }), "bad.gltf: is nested deeper than 256 levels");
}

TEST(GltfFile, BytesOfChanceAreReadOrRefused) {
    const std::string text = tetrahedron().text();
    const std::string binary = tetrahedron().binary();
    for (std::uint64_t i = 0; i < 4000; ++i) {
        Random random(20261126, {i});
        std::string bytes = i % 2 == 0 ? text : binary;
        for (std::uint64_t change = 0; change <= i % 3; ++change)
            bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
        const std::string message = messageOf([&] {
            MeshData mesh = parseGltf(bytes, "bad.gltf");
            checkMesh(mesh);
            return mesh;
        });
        EXPECT_TRUE(message == "no error" || message.starts_with("bad.gltf")) << message;
    }
}

TEST(FromTheField, FaultyGltfIsRefusedByName) {
    const auto message = [](const char* name) {
        return messageOf([&] { return loadMesh(test::sourceDir() / "tests/04_kd_tree/field" / name); });
    };
    EXPECT_NE(message("unknown_required.gltf").find("EXT_example_shape"), std::string::npos);
    const std::string index = message("index_out_of_range.gltf");
    EXPECT_NE(index.find("accessor 1 has an index that names no vertex; there are 4 (got '9')"), std::string::npos)
        << index;
}

}  // namespace
}  // namespace caustic
