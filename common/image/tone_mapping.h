#pragma once

#include "image/image.h"

namespace caustic {

/// Brings a radiance into what a display can show, in [0, 1] for luminances up to `white`; hue and saturation stay as
/// long as no channel is cut off.
///
/// The luminance Y, times the exposure, becomes Y (1 + Y/white²) / (1 + Y): dark places stay as they are, bright ones
/// are compressed, `white` becomes 1. Source: Reinhard et al. 2002, Photographic Tone Reproduction, eq. 4.
/// @param radiance  each channel at least 0
/// @param exposure  factor before anything else, greater than 0
/// @param white     the smallest luminance, times the exposure, that is shown as white; greater than 0
Color toneMapped(const Color& radiance, Real exposure, Real white);

/// The same for each pixel.
/// @throws InputError unless exposure and white are finite and greater than 0
Image toneMapped(const Image& image, Real exposure, Real white);

}  // namespace caustic
