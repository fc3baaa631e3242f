#pragma once

#include <algorithm>
#include <cstddef>

#include "math/bounds.h"
#include "math/vector.h"

namespace caustic {

/// Where things are in the editor's window, in pixels: what the painter draws there, the mouse finds there.
namespace editor_layout {

/// Sizes of the window and of its parts.
inline constexpr int width = 1200;
inline constexpr int height = 720;
inline constexpr int panelWidth = 300;   ///< on the right
inline constexpr int footerHeight = 72;  ///< slider and status line, below the sheet
inline constexpr Real pointRadius = 5;   ///< of a control point's mark
inline constexpr Real reach = 9;         ///< how far beside a point or curve a click still means it
inline constexpr std::size_t chooserRows = 9;
inline constexpr Real chooserRowHeight = 30;

/// The part of the window that shows the curve.
inline Bounds2 sheet() { return {Vec2(0, 0), Vec2(width - panelWidth, height - footerHeight)}; }

/// The slider's track, from t = 0 to the end of the curve: a horizontal line.
inline Vec2 sliderStart() { return {96, height - footerHeight + 24}; }
inline Vec2 sliderEnd() { return {width - panelWidth - 110, height - footerHeight + 24}; }

/// Whether the mouse is on the slider's track.
inline bool onSlider(const Vec2& pixel) {
    return std::abs(pixel.y() - sliderStart().y()) <= 12 && pixel.x() >= sliderStart().x() - 12 &&
           pixel.x() <= sliderEnd().x() + 12;
}

/// Which share of the track lies left of a pixel, in [0, 1].
inline Real sliderShare(const Vec2& pixel) {
    const Real share = (pixel.x() - sliderStart().x()) / (sliderEnd().x() - sliderStart().x());
    return std::clamp(share, Real(0), Real(1));
}

/// Row i of the list of profiles to open.
inline Bounds2 chooserRow(std::size_t i) {
    const Vec2 corner(60, 110 + chooserRowHeight * Real(i));
    return {corner, corner + Vec2(560, chooserRowHeight)};
}

}  // namespace editor_layout

}  // namespace caustic
