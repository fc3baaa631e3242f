#pragma once

#include "math/color.h"

namespace caustic {

/// The sRGB transfer function: linear value in [0, 1] → encoded value in [0, 1], as it is stored in a PNG and sent to a
/// display. Values outside are clamped, NaN becomes 0. Source: IEC 61966-2-1, the piecewise form (linear near black,
/// exponent 1/2.4).
Real srgbEncode(Real linear);

/// Inverse of srgbEncode: encoded value in [0, 1] → linear value in [0, 1]. Values outside are clamped.
Real srgbDecode(Real encoded);

/// The same, channel by channel.
Color srgbEncode(const Color& linear);
/// The same, channel by channel.
Color srgbDecode(const Color& encoded);

/// HSV → RGB, in whatever space the result is meant (encoded, usually: HSV is made for choosing colours on a display).
/// Source: Smith 1978, "Color gamut transform pairs".
/// @param hue         in turns, any finite number, period 1: 0 red, 1/3 green, 2/3 blue
/// @param saturation  in [0, 1]: 0 grey, 1 pure
/// @param value       the largest channel, at least 0
Color hsvToRgb(Real hue, Real saturation, Real value);

}  // namespace caustic
