#pragma once

#include <cstdint>

#include "image/image.h"

namespace caustic {

/// The images that the chapter makes itself.

/// Planks of oak, side by side: reflectances, one plank a quarter of the height. Repeats.
Image woodPattern(int width, int height, std::uint64_t seed);

/// A window of six panes with leads between them, brighter in the middle of each pane: radiances of about 1.
Image windowPattern(int width, int height);

/// Heights of hammered metal, dents as a hammer leaves them, for normalsOfHeights. Repeats.
/// @param dents  along each side
/// @param depth  of a dent over its width
Image hammeredPattern(int side, int dents, Real depth, std::uint64_t seed);

/// Heights of flutes that run along x (up the glass) within [from, to] of the width and are `flutes` along y.
/// @param slope  the steepest
Image flutedPattern(int width, int height, int flutes, Real from, Real to, Real slope);

}  // namespace caustic
