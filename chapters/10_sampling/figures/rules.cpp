#include "core/progress.h"
#include "figures.h"
#include "figures/heat.h"
#include "image/tiles.h"
#include "sampling/independent_sampler.h"
#include "scenes.h"

namespace caustic {

void drawRules(FigureContext& context) {
    constexpr int shown = 330;
    const int width = context.byQuality(55, 165);
    const Study& what = study("bunny");
    const Scene scene = what.scene(assetOf(what, context), width);
    RayCounts counts;
    const HashRule hash(scene, 12, context.threads(), counts);
    const EdgeRule edge(0.04);
    const IntervalRule interval(0.02);
    const GainRule gain;
    const auto tile = [&](const std::string& caption, const AdaptiveRule& rule) {
        return Tile{caption, [&](int, int) {
                        const IndependentSampler sampler(context.seed());
                        const auto inner = what.method(scene, sampler);
                        AdaptiveIntegrator adaptive(
                            *inner, sampler, rule,
                            {.batch = 4, .first = 8, .paths = std::int64_t{32} * width * width, .share = 0.1});
                        requireFinite(renderAdaptively(adaptive, {.threads = context.threads()}));
                        return heatMap(adaptive, 8, 512);
                    }};
    };
    drawTiles({tile("① path hash", hash), tile("② edges", edge), tile("③ widest interval", interval),
               tile("largest gain", gain)},
              shown, shown, "rules.png", context);
}

}  // namespace caustic
