#pragma once

#include <filesystem>
#include <memory>

#include "shape/shape.h"

namespace caustic {

/// The Utah teapot of 32 exact patches, z up, in units of its own: 3.15 high, 6.43 long.
/// @throws InputError when the file can't be read or doesn't hold patches as chapter 03 writes them
std::shared_ptr<const Shape> loadTeapot(const std::filesystem::path& file);

}  // namespace caustic
