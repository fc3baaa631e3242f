#pragma once

#include <filesystem>
#include <string_view>

namespace caustic {

/// Looks whether a PLY file holds all that its header announces: assimp 5.2, which reads it, takes much of what is cut
/// short for whole, and reads on for ever where the header has no end.
/// Source: Turk 1994, The PLY Polygon File Format.
/// @throws InputError when the header doesn't end, announces what no PLY file holds, or the data end too early
void checkPly(std::string_view content, const std::filesystem::path& path);

}  // namespace caustic
