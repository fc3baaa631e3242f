#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "curve/bezier_patch.h"

namespace caustic {

/// A patch as a file names it.
struct NamedPatch {
    std::string name;
    BezierPatch patch;
};

/// Reads patches from text:
///
///     patch lid 3 3                   # a name, two degrees
///     0 0 1  0.1 0 1  0.2 0 1  ...    # a row of control points a line, x y z each
///     ...
///
/// @param file  what errors call it
/// @throws InputError with the line for anything else
std::vector<NamedPatch> parsePatches(std::string_view text, const std::string& file);

/// Reads a file of patches.
/// @throws InputError when it can't be read, and as parsePatches
std::vector<NamedPatch> loadPatches(const std::filesystem::path& path);

}  // namespace caustic
