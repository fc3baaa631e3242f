#include "figures.h"
#include "figures/picture.h"
#include "image/image_file.h"
#include "image/tiles.h"
#include "scenes.h"

namespace caustic {

void drawBox(FigureContext& context) {
    const int width = context.byQuality(400, 800);
    const SceneDescription scene = boxScene(width, width * 3 / 4);
    saveImage(context.output("box.png"),
              takePicture(scene, {context.byQuality(2, 5), {.maxDepth = 12, .leastWeight = 1e-3, .shadowSamples = 4}},
                          context));
}

void drawDepth(FigureContext& context) {
    std::vector<Tile> tiles;
    for (const int depth : {0, 1, 2, 3, 8}) {
        tiles.push_back({"depth " + std::to_string(depth), [&context, depth](int width, int height) {
                             return takePicture(boxScene(width, height),
                                                {context.byQuality(2, 4), {.maxDepth = depth, .shadowSamples = 2}},
                                                context);
                         }});
    }
    drawTiles(tiles, 280, 240, "depth.png", context);
}

}  // namespace caustic
