#pragma once

#include <cstdint>

#include "math/real.h"

namespace caustic {

/// A colour to draw with: sRGB code values, and how much of what is below it covers.
struct Ink {
    std::uint8_t red = 0;    ///< sRGB code
    std::uint8_t green = 0;  ///< sRGB code
    std::uint8_t blue = 0;   ///< sRGB code
    Real alpha = 1;          ///< 0 leaves no trace, 1 covers

    /// The same colour with another coverage.
    /// The same colour, letting more or less shine through.
    constexpr Ink withAlpha(Real newAlpha) const { return {red, green, blue, newAlpha}; }
    /// Equal in all four numbers.
    /// Equal in all four.
    friend constexpr bool operator==(const Ink&, const Ink&) = default;
};

/// The colours of all figures, drawn or plotted: those of figure/style.gp. The first six are Okabe and Ito's (2008),
/// told apart by colour-blind readers too.
namespace palette {

/// Colours of lines and areas, in the order in which a chart takes them.
inline constexpr Ink blue{0x00, 0x72, 0xb2};       ///< line type 1
inline constexpr Ink vermilion{0xd5, 0x5e, 0x00};  ///< line type 2
inline constexpr Ink green{0x00, 0x9e, 0x73};      ///< line type 3
inline constexpr Ink purple{0xcc, 0x79, 0xa7};     ///< line type 4
inline constexpr Ink orange{0xe6, 0x9f, 0x00};     ///< line type 5
inline constexpr Ink sky{0x56, 0xb4, 0xe9};        ///< line type 6
inline constexpr Ink dark{0x44, 0x44, 0x44};       ///< line type 7: grey, for outlines
inline constexpr Ink brown{0xa6, 0x76, 0x1d};      ///< line type 8

/// Colours of labels, of grid lines, of the paper.
inline constexpr Ink text{0x22, 0x22, 0x22};   ///< of titles and labels
inline constexpr Ink grid{0xdd, 0xdd, 0xdd};   ///< of grid lines
inline constexpr Ink white{0xff, 0xff, 0xff};  ///< of the paper

}  // namespace palette

}  // namespace caustic
