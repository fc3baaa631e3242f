#include "core/progress.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/image_file.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "scenes.h"

namespace caustic {

namespace {

Image glassPicture(const std::string& name, int width, int height, std::int64_t passes, int photons,
                   FigureContext& context) {
    const NamedScene& named = namedScene(name);
    SppmSettings settings = named.settings;
    settings.photons = photons;
    const Scene scene(named.make(width, height, context.asset(glassProfile).string()));
    return toneMapped(sppmPicture(scene, settings, passes, context), named.exposure, 4);
}

}  // namespace

void drawWineGlass(FigureContext& context) {
    const int width = context.byQuality(225, 480);
    context.progress().expect(pictureSteps);
    const Image picture = glassPicture("wine_glass", width, width * 4 / 3, context.byQuality(8, 160), 1 << 18, context);
    saveImage(context.output("wine_glass.png"), picture);
}

void drawPasses(FigureContext& context) {
    constexpr int width = 450;
    constexpr int height = 600;
    const int scale = context.byQuality(3, 1);
    context.progress().expect(2 * pictureSteps);
    const auto tile = [&](const std::string& caption, std::int64_t passes, int photons) {
        return Tile{caption, [&context, passes, photons, scale](int, int) {
                        return glassPicture("empty_glass", width / scale, height / scale, passes, photons, context);
                    }};
    };
    const int passes = context.byQuality(10, 100);
    drawTiles({tile("1 pass of " + std::to_string(passes) + " times the photons", 1, passes << 16),
               tile(std::to_string(passes) + " passes", passes, 1 << 16)},
              width, height, "passes.png", context);
}

}  // namespace caustic
