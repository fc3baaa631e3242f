#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "image/palette.h"
#include "math/vector.h"

/// Colours of the editor, and how it writes numbers.
namespace caustic::editor_style {

inline constexpr Ink paper{0xff, 0xff, 0xff};         ///< behind the drawing
inline constexpr Ink panelPaper{0xf4, 0xf5, 0xf7};    ///< behind the panel
inline constexpr Ink faint{0xee, 0xee, 0xee};         ///< grid lines
inline constexpr Ink quiet{0x77, 0x77, 0x77};         ///< what is said by the way
inline constexpr Ink curveInk = palette::blue;        ///< the curve
inline constexpr Ink handleInk = palette::vermilion;  ///< handles
inline constexpr Ink boxInk = palette::green;         ///< bounding boxes
inline constexpr Ink chosenInk = palette::orange;     ///< what is chosen

/// A number with so many significant digits.
inline std::string number(Real value, int digits = 5) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0 ? 0 : value);
    return text.data();
}

/// Both coordinates.
inline std::string pair(const Vec2& point) { return number(point.x(), 4) + ", " + number(point.y(), 4); }

}  // namespace caustic::editor_style
