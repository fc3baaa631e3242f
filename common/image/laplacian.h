#pragma once

#include "image/image.h"

namespace caustic {

/// The 5-point Laplacian of each channel: left + right + above + below − 4 · centre, in value per pixel².
///
/// Zero where the picture is linear, large at edges: an edge detector, which chapter 10 uses to see where a picture
/// needs more samples. Beyond the border the border's pixels go on, so that a constant picture has no edge there. May
/// be negative.
Image laplacian(const Image& image);

}  // namespace caustic
