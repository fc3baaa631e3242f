#include "support/gltf_writer.h"

#include "support/mesh_files.h"

namespace caustic::test {

namespace {

using Json = nlohmann::json;

std::string base64(const std::string& bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            value = value << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[value >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

int componentType(const std::string& type) {
    if (type == "char") return 5120;
    if (type == "uchar") return 5121;
    if (type == "short") return 5122;
    if (type == "ushort") return 5123;
    return type == "uint" ? 5125 : 5126;
}

std::string padded(std::string bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
    return bytes;
}

}  // namespace

GltfWriter::GltfWriter()
    : json({{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
            {"nodes", Json::array({{{"mesh", 0}}})},
            {"meshes", Json::array({{{"primitives", Json::array()}}})},
            {"accessors", Json::array()},
            {"bufferViews", Json::array()}}) {}

int GltfWriter::addView(const std::string& bytes, std::size_t stride) {
    buffer_ = padded(buffer_, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) view["byteStride"] = stride;
    json["bufferViews"].push_back(view);
    buffer_ += bytes;
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfWriter::add(const std::vector<Real>& values, std::size_t components, const std::string& type, bool normalized,
                    std::size_t stride) {
    std::string bytes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t element = i / components * stride;
        if (i % components == 0) bytes.resize(std::max(bytes.size(), element), '\x7f');
        bytes += bytesOf(values[i], type);
    }
    const int view = addView(bytes, stride);
    const char* const kind = components == 1 ? "SCALAR" : components == 2 ? "VEC2" : "VEC3";
    json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", componentType(type)},
                                 {"count", values.size() / components},
                                 {"normalized", normalized},
                                 {"type", kind}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

void GltfWriter::addPrimitive(const Json& attributes, int indices, int mode) {
    Json primitive = {{"attributes", attributes}, {"mode", mode}};
    if (indices >= 0) primitive["indices"] = indices;
    json["meshes"][0]["primitives"].push_back(primitive);
}

std::string GltfWriter::text() const {
    Json whole = json;
    const std::string uri = "data:application/octet-stream;base64," + base64(buffer_);
    if (!whole.contains("buffers")) whole["buffers"] = Json::array({{{"byteLength", buffer_.size()}, {"uri", uri}}});
    return whole.dump();
}

std::string GltfWriter::binary() const {
    Json whole = json;
    const std::string data = padded(buffer_, '\0');
    whole["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
    const std::string text = padded(whole.dump(), ' ');
    const auto number = [](std::size_t value) { return bytesOf(static_cast<Real>(value), "uint"); };
    return "glTF" + number(2) + number(28 + text.size() + data.size()) + number(text.size()) + "JSON" + text +
           number(data.size()) + std::string("BIN\0", 4) + data;
}

}  // namespace caustic::test
