#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "mesh_shape.h"
#include "scenes.h"

namespace caustic {

void drawBeerLambert(FigureContext& context) {
    const auto bunny = loadShape(context.asset("assets/meshes/bunny.ply"));
    const auto tile = [&](const std::string& caption, const Color& perUnit) {
        return Tile{
            caption, [&context, bunny, perUnit](int width, int height) {
                const SceneObject glass = {.shape = bunny, .material = clearGlass(), .interior = glassOf(perUnit)};
                return takePicture(meshScene(glass, width, height),
                                   {context.byQuality(1, 4), {.maxDepth = 10, .leastWeight = 1e-3, .shadowSamples = 2}},
                                   context);
            }};
    };
    drawTiles({tile("I = (1, 1, 1)", Color::Ones()), tile("I = (0.2, 0.75, 0.3)", Color(0.2, 0.75, 0.3)),
               tile("I = (0.02, 0.5, 0.06)", Color(0.02, 0.5, 0.06))},
              430, 430, "beer_lambert.png", context);
}

}  // namespace caustic
