#include "importance.h"

#include "camera/box_filter.h"
#include "figures.h"
#include "image/tiles.h"
#include "integrator/picture.h"
#include "measures/lit_floor.h"
#include "sampling/independent_sampler.h"

namespace caustic {

void drawImportance(FigureContext& context) {
    constexpr int shown = 330;
    constexpr int rays = 4;
    const LitFloor floor = LitFloor::beside(context.byQuality(shown / 2, shown));
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    std::vector<Tile> tiles;
    for (const Importance density : {Importance::Uniform, Importance::Cosine, Importance::Lamp, Importance::Both})
        tiles.push_back({nameOf(density), [&, density](int, int) {
                             ImportanceTracer tracer(floor.scene(), sampler, filter, density);
                             return takePicture(tracer, rays, {1, 4}, context);
                         }});
    drawTiles(tiles, shown, shown, "importance.png", context);
}

}  // namespace caustic
