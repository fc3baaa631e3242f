#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/figure.h"
#include "image/image.h"

namespace caustic {

/// A picture with a caption.
struct Tile {
    std::string caption;
    std::function<Image(int width, int height)> take;
};

/// Takes the pictures one after the other and puts them side by side, captions above.
void drawTiles(const std::vector<Tile>& tiles, int width, int height, const std::string& png, FigureContext& context);

}  // namespace caustic
