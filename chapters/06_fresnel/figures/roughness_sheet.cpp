#include "camera/tent_filter.h"
#include "core/text.h"
#include "figures.h"
#include "figures/glossy_tracer.h"
#include "image/tiles.h"
#include "integrator/picture.h"
#include "material/rough_conductor_material.h"
#include "material/rough_dielectric_material.h"
#include "sampling/stratified_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

Tile ballTile(const std::string& caption, std::shared_ptr<const Material> material, bool glass,
              FigureContext& context) {
    return {caption, [&context, material = std::move(material), glass](int width, int height) {
                const int perAxis = context.byQuality(2, 9);
                const Scene scene(ballScene(material, glass, width, height));
                const StratifiedSampler sampler(context.seed(), perAxis);
                const TentFilter filter;
                GlossyTracer tracer(scene, sampler, filter, 12);
                return takePicture(tracer, perAxis * perAxis, {.exposure = 1.3}, context);
            }};
}

Tile metalTile(const std::string& caption, const Metal& metal, Real alphaX, Real alphaY, FigureContext& context) {
    return ballTile(caption, std::make_shared<RoughConductorMaterial>(metal, alphaX, alphaY), false, context);
}

}  // namespace

void drawRoughnessSheet(FigureContext& context) {
    struct Roughness {
        Real coarse;
        Real fine;  // a tenth
    };
    constexpr Roughness roughnesses[] = {{0, 0}, {0.05, 0.005}, {0.15, 0.015}, {0.35, 0.035}, {0.7, 0.07}};
    std::vector<Tile> tiles;
    const auto pair = [](Real alphaX, Real alphaY) { return formatReal(alphaX) + " × " + formatReal(alphaY); };
    for (const auto& [coarse, fine] : roughnesses)
        tiles.push_back(metalTile("gold, " + formatReal(coarse), Metal::gold(), coarse, coarse, context));
    for (const auto& [coarse, fine] : roughnesses)
        tiles.push_back(metalTile("copper, " + pair(fine, coarse), Metal::copper(), fine, coarse, context));
    for (const auto& [coarse, fine] : roughnesses)
        tiles.push_back(metalTile("copper, " + pair(coarse, fine), Metal::copper(), coarse, fine, context));
    for (const auto& [coarse, fine] : roughnesses) {
        const auto glass = std::make_shared<RoughDielectricMaterial>(coarse, coarse);
        tiles.push_back(ballTile("glass, " + formatReal(coarse), glass, true, context));
    }
    drawTiles(tiles, 250, 230, "roughness_sheet.png", context, 5);
}

}  // namespace caustic
