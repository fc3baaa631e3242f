#include "camera/tent_filter.h"
#include "figures.h"
#include "final_command.h"
#include "final_scene.h"
#include "image/tiles.h"
#include "integrator/picture.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

void drawParts(FigureContext& context) {
    const auto asset = [&](const std::string& path) { return context.asset(path); };
    const auto tile = [&](const std::string& caption, const FinalParts& parts) {
        return Tile{caption, [&context, asset, parts](int width, int height) {
                        const int scale = context.byQuality(4, 1);
                        const Scene scene(finalScene(parts, asset, width / scale, height / scale));
                        const SobolSampler sampler(context.seed());
                        const TentFilter filter;
                        VolumeSppm sppm(scene, sampler, filter, finalSettings(context.byQuality(1 << 13, 1 << 16)));
                        return developedFinal(renderImage(sppm, context.byQuality(4, 128), context));
                    }};
    };
    drawTiles({tile("before this chapter", {false, false, false, false, false}),
               tile("and a panorama", {true, false, false, false, false}),
               tile("and textures", {true, true, false, false, false}),
               tile("and normal maps", {true, true, true, false, false}),
               tile("and a lens", {true, true, true, true, false}), tile("and haze", {})},
              320, 200, "parts.png", context, 3);
}

}  // namespace caustic
