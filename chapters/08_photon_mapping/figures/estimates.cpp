#include <string>

#include "core/progress.h"
#include "figures.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/render.h"
#include "modeler/caustic_scene.h"
#include "picture.h"

namespace caustic {

namespace {

constexpr int shownSide = 300;

struct Estimate {
    std::string caption;
    DensitySettings density;
};

}  // namespace

void drawEstimates(FigureContext& context) {
    const std::vector<Estimate> estimates = {
        {"10 nearest photons", {.nearest = 10, .radius = 2}},
        {"80 nearest", {.nearest = 80, .radius = 2}},
        {"640 nearest", {.nearest = 640, .radius = 2}},
        {"80 nearest, cone filter", {.nearest = 80, .radius = 2, .cone = 1}},
        {"all within 1 cm", {.nearest = {}, .radius = 0.01}},
        {"all within 3 cm", {.nearest = {}, .radius = 0.03}},
        {"all within 10 cm", {.nearest = {}, .radius = 0.1}},
        {"all within 3 cm, cone filter", {.nearest = {}, .radius = 0.03, .cone = 1}}};
    const int side = context.byQuality(shownSide / 2, shownSide);
    const Scene scene(CausticScene{}.onFloor(side));
    context.progress().expect(static_cast<std::int64_t>(estimates.size()) * progressSteps);
    std::vector<Tile> tiles;
    for (const Estimate& one : estimates) {
        PhotonMapperSettings settings = {.photons = context.byQuality(50'000, 200'000), .use = MapUse::Everything};
        settings.density = one.density;
        const Image picture = toneMapped(photonPicture(scene, settings, 1, context), 0.25, 4);
        tiles.push_back({one.caption, [picture](int, int) { return picture; }});
    }
    drawTiles(tiles, shownSide, shownSide, "estimates.png", context, 4);
}

}  // namespace caustic
