#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figure/figure.h"
#include "image/image.h"

namespace caustic {

/// A picture with a caption.
struct Tile {
    std::string caption;                               ///< stands above it
    std::function<Image(int width, int height)> take;  ///< takes it, in the size that it will be shown in
};

/// Takes the pictures one after the other and puts them side by side, captions above.
/// @param columns  of a row, at least 1; more tiles start a row below
void drawTiles(const std::vector<Tile>& tiles, int width, int height, const std::string& png, FigureContext& context,
               int columns = 8);

}  // namespace caustic
