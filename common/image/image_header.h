#pragma once

#include <cstdint>
#include <filesystem>

namespace caustic {

/// The kinds of image file that the course reads.
enum class ImageFormat {
    Png,      ///< Portable Network Graphics
    Jpeg,     ///< JPEG in any container that starts with its marker
    OpenExr,  ///< OpenEXR, one part
    Radiance  ///< Radiance RGBE, often named .hdr
};

/// What the first bytes of an image file say.
struct ImageHeader {
    ImageFormat format;   ///< told by the content
    std::int64_t width;   ///< columns, as stated; may be absurd
    std::int64_t height;  ///< rows, as stated; may be absurd
};

/// Finds out format and size of an image without decoding it, so that a file that promises an absurd size costs
/// nothing. The format is told by the content, never by the name.
/// @throws InputError when the file is missing, a folder, unreadable, empty, of another format, or ends within its
///         header
ImageHeader readImageHeader(const std::filesystem::path& path);

}  // namespace caustic
