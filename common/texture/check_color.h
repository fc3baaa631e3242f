#pragma once

#include <string_view>

#include "math/color.h"

namespace caustic {

/// Throws InputError unless every channel is finite and at least 0.
void checkNotNegative(const Color& color, std::string_view what);

/// Throws InputError unless every channel is in [0, 1]: a surface that gives back more light than it gets is none.
void checkReflectance(const Color& color, std::string_view what);

}  // namespace caustic
