#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace caustic::test {

/// Where rendering the scene "thumbnail" leaves its picture, below the folder to write to.
inline constexpr const char* thumbnailPicture = "09_sppm/render_thumbnail.png";

/// All bytes of a file; none when it is missing.
inline std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace caustic::test
