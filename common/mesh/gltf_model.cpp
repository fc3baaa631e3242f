#include "mesh/gltf_model.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "mesh/scalar_type.h"

namespace caustic {

namespace {

constexpr std::size_t deepest = 256;

class ModelReader {
public:
    ModelReader(std::string_view content, const std::filesystem::path& path) : content_(content), path_(path) {}

    tinygltf::Model read() {
        const bool binary = content_.starts_with("glTF");
        checkDepth(binary ? jsonOfBinary() : content_);
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                                 void*) { return true; },
                              nullptr);  // pictures have no shape
        load(loader, binary);
        if (!model_.asset.version.starts_with("2.")) fail(model_.asset.version, "must be glTF of version 2");
        for (const std::string& extension : model_.extensionsRequired) checkExtension(extension);
        return std::move(model_);
    }

private:
    [[noreturn]] void fail(const std::string& value, const std::string& reason) const {
        throw InputError({path_.string(), 0}, value, reason);
    }

    // The library throws what its JSON parser and its vectors throw.
    void load(tinygltf::TinyGLTF& loader, bool binary) {
        std::string error;
        std::string warning;
        const std::string folder = path_.parent_path().string();
        const auto size = static_cast<unsigned>(content_.size());
        bool fine = false;
        try {
            fine = binary ? loader.LoadBinaryFromMemory(&model_, &error, &warning,
                                                        reinterpret_cast<const unsigned char*>(content_.data()), size,
                                                        folder)
                          : loader.LoadASCIIFromString(&model_, &error, &warning, content_.data(), size, folder);
        } catch (const std::exception& exception) {
            error = exception.what();
        }
        if (fine) return;
        const std::string_view first = trimmed(error);
        fail("", "is no glTF that can be read: " + std::string(first.substr(0, first.find('\n'))));
    }

    std::uint64_t numberAt(std::size_t place) const {
        if (content_.size() < place + 4) fail("", "is cut short");
        return static_cast<std::uint64_t>(readScalar(content_.data() + place, ScalarType::Uint32, std::endian::little));
    }

    // Khronos 2021, 4.4: 12 bytes of header, then chunks of 8 bytes and their data.
    std::string_view jsonOfBinary() const {
        const std::uint64_t length = numberAt(8);
        const std::uint64_t jsonEnd = 20 + numberAt(12);
        if (length != content_.size())
            fail(std::to_string(content_.size()) + " bytes", "must be " + std::to_string(length) + ": it is cut short");
        if (jsonEnd > length) fail("", "has a chunk that ends after the file");
        if (jsonEnd < length && jsonEnd + 8 + numberAt(jsonEnd) > length)
            fail("", "has a chunk that ends after the file");
        return content_.substr(20, jsonEnd - 20);
    }

    void checkDepth(std::string_view json) const {
        std::size_t depth = 0;
        bool text = false;
        for (std::size_t i = 0; i < json.size(); ++i) {
            const char c = json[i];
            if (text && c == '\\') {
                ++i;
            } else if (c == '"') {
                text = !text;
            } else if (!text && (c == '[' || c == '{')) {
                if (++depth > deepest) fail("", "is nested deeper than " + std::to_string(deepest) + " levels");
            } else if (!text && (c == ']' || c == '}') && depth > 0) {
                --depth;
            }
        }
    }

    // Materials, textures and lights have no shape; quantised attributes are read.
    void checkExtension(const std::string& name) const {
        for (const char* harmless : {"KHR_materials_", "KHR_texture_", "KHR_lights_"}) {
            if (name.starts_with(harmless)) return;
        }
        if (name != "KHR_mesh_quantization")
            fail(name, "is an extension that the file requires and that is unknown here");
    }

    std::string_view content_;
    const std::filesystem::path& path_;
    tinygltf::Model model_;
};

}  // namespace

tinygltf::Model loadGltfModel(std::string_view content, const std::filesystem::path& path) {
    return ModelReader(content, path).read();
}

}  // namespace caustic
