#include "image/tiles.h"

#include <algorithm>

#include "core/progress.h"
#include "image/drawing.h"

namespace caustic {

void drawTiles(const std::vector<Tile>& tiles, int width, int height, const std::string& png, FigureContext& context,
               int columns) {
    constexpr int gap = 12;
    constexpr int top = 46;
    const int count = static_cast<int>(tiles.size());
    const int perRow = std::min(count, columns);
    const int rows = (count + perRow - 1) / perRow;
    Drawing drawing(gap + perRow * (width + gap), rows * (top + height) + gap);
    context.progress().expect(count);
    for (int i = 0; i < count; ++i) {
        const Tile& tile = tiles[static_cast<std::size_t>(i)];
        const Vec2 corner(gap + i % perRow * (width + gap), top + i / perRow * (top + height));
        drawing.text(corner + Vec2(width / 2.0, -16), tile.caption,
                     {.size = 20, .horizontal = HorizontalAnchor::Centre});
        drawing.image(tile.take(width, height), {corner, corner + Vec2(width, height)});
        context.progress().advance();
    }
    drawing.save(context.output(png));
}

}  // namespace caustic
