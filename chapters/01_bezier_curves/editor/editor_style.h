#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "image/palette.h"
#include "math/vector.h"

/// Colours of the editor, and how it writes numbers.
namespace caustic::editor_style {

inline constexpr Ink paper{0xff, 0xff, 0xff};
inline constexpr Ink panelPaper{0xf4, 0xf5, 0xf7};
inline constexpr Ink faint{0xee, 0xee, 0xee};
inline constexpr Ink quiet{0x77, 0x77, 0x77};
inline constexpr Ink curveInk = palette::blue;
inline constexpr Ink handleInk = palette::vermilion;
inline constexpr Ink boxInk = palette::green;
inline constexpr Ink chosenInk = palette::orange;

/// A number with so many significant digits.
inline std::string number(Real value, int digits = 5) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0 ? 0 : value);
    return text.data();
}

/// Both coordinates.
inline std::string pair(const Vec2& point) { return number(point.x(), 4) + ", " + number(point.y(), 4); }

}  // namespace caustic::editor_style
