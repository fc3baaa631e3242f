#include "tiles.h"

#include "core/progress.h"
#include "image/drawing.h"

namespace caustic {

void drawTiles(const std::vector<Tile>& tiles, int width, int height, const std::string& png, FigureContext& context) {
    constexpr int gap = 12;
    constexpr int top = 46;
    const int count = static_cast<int>(tiles.size());
    Drawing drawing(gap + count * (width + gap), top + height + gap);
    context.progress().expect(count);
    Real x = gap;
    for (const Tile& tile : tiles) {
        drawing.text({x + width / 2.0, top - 16.0}, tile.caption, {.size = 20, .horizontal = HorizontalAnchor::Centre});
        drawing.image(tile.take(width, height), {Vec2(x, top), Vec2(x + width, top + height)});
        x += width + gap;
        context.progress().advance();
    }
    drawing.save(context.output(png));
}

}  // namespace caustic
