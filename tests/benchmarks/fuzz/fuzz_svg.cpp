// libFuzzer on the SVG reader: whatever the bytes are, they are read or refused with an InputError.

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "curve/svg_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace caustic;
    try {
        const SvgDocument document = parseSvg(std::string(reinterpret_cast<const char*>(data), size), "fuzz.svg");
        for (const SvgPathElement& path : document.paths) svgSplines(path);
    } catch (const InputError&) {
        // Bad input, said so.
    }
    return 0;
}
