#pragma once

#include <filesystem>

#include "image/image.h"

namespace caustic {

/// What the integers of a PNG or JPEG stand for. OpenEXR and Radiance hold linear floats and don't ask.
enum class Encoding {
    Srgb,   ///< colours: code / largest code is sRGB-encoded, and decoded on loading
    Linear  ///< data, as in normal maps: the value is code / largest code
};

/// Bits per channel of a PNG.
enum class PngDepth {
    Bits8,  ///< 256 codes
    Bits16  ///< 65536 codes
};

/// Reads a PNG (8 or 16 bits), JPEG, OpenEXR or Radiance file; the content tells which. Grey images get three equal
/// channels, alpha is dropped, photographs are turned upright as their EXIF data say.
/// @throws InputError when the file is missing, a folder, unreadable, empty, of another format, truncated, damaged, of
///         no or an absurd size (Image::mostPixels), or holds a value that is not finite
Image loadImage(const std::filesystem::path& path, Encoding encoding = Encoding::Srgb);

/// Writes an image through a temporary file and a rename; the extension says how: `.png` sRGB-encoded, clamped to
/// [0, 1], rounded to the nearest code; `.exr` linear 32-bit floats; `.hdr` linear with a shared exponent (relative
/// error up to 1/256 of the largest channel; it has no sign, so negative values become 0).
/// @param depth  of a PNG
/// @throws InputError when the extension is another one, a value is not finite, or the file cannot be written
void saveImage(const std::filesystem::path& path, const Image& image, PngDepth depth = PngDepth::Bits8);

}  // namespace caustic
