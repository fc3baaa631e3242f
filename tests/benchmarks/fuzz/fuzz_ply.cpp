// libFuzzer on the PLY reader: whatever the bytes are, they are read or refused with an InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "mesh/mesh_data.h"
#include "mesh/ply_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace caustic;
    try {
        checkMesh(parsePly({reinterpret_cast<const char*>(data), size}, "fuzz.ply"));
    } catch (const InputError&) {
        // Bad input, said so.
    }
    return 0;
}
