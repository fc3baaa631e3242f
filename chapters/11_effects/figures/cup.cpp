#include "camera/box_filter.h"
#include "figures.h"
#include "fluted_cup.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/picture.h"
#include "integrator/sppm.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

void drawCup(FigureContext& context) {
    const auto profile = context.asset("assets/profiles/teacup.svg");
    const auto tile = [&](const std::string& caption, std::optional<Lookup> lookup) {
        return Tile{
            caption, [&context, profile, lookup](int width, int height) {
                const Scene scene(flutedCup(lookup, profile, width, height));
                const SobolSampler sampler(context.seed());
                const BoxFilter filter;
                Sppm sppm(
                    scene, sampler, filter,
                    {.limits = {.maxLength = 24}, .radius = 1.6e-3, .photons = context.byQuality(1 << 16, 1 << 18)});
                return toneMapped(renderImage(sppm, context.byQuality(1, 32), context), 1.2, 4);
            }};
    };
    drawTiles({tile("smooth", std::nullopt), tile("map by nearest pixel", Lookup::Nearest),
               tile("map bilinear", Lookup::Bilinear)},
              460, 400, "cup.png", context);
}

}  // namespace caustic
