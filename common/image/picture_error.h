#pragma once

#include <vector>

#include "image/image.h"

namespace caustic {

/// Root mean square error of a picture, over all pixels and the three linear channels.
/// @param leftOut  which pixels don't count, row by row from the top; empty for none
/// @throws InputError when the sizes differ or no pixel counts
Real rmse(const Image& picture, const Image& reference, const std::vector<bool>& leftOut = {});

}  // namespace caustic
