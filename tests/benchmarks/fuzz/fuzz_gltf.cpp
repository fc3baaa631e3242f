// libFuzzer on the glTF reader and tinygltf below it: whatever the bytes are, they are read or refused with an
// InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "mesh/gltf_file.h"
#include "mesh/mesh_data.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace caustic;
    try {
        checkMesh(parseGltf({reinterpret_cast<const char*>(data), size}, "fuzz.gltf"));
    } catch (const InputError&) {
        // Bad input, said so.
    }
    return 0;
}
