#include "camera/box_filter.h"
#include "core/progress.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/photon_mapper.h"
#include "integrator/render.h"
#include "modeler/caustic_scene.h"
#include "sampling/sobol_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

constexpr int width = 560;
constexpr int height = 420;
constexpr int photonsAPass = 1 << 15;

// One map of all photons, looked at by as many paths from the eye as SPPM has passes.
Image oneMap(const Scene& scene, const SppmSettings& settings, std::int64_t passes, FigureContext& context) {
    const SobolSampler sampler(context.seed());
    const BoxFilter filter;
    PhotonMapperSettings own;
    own.photons = passes * photonsAPass;
    own.limits = settings.limits;
    own.density = {.nearest = std::nullopt, .radius = settings.radius};
    own.caustics = own.density;
    PhotonMapper mapper(scene, sampler, filter, own, context.threads());
    const Rendering rendering =
        render(mapper, {.passes = passes, .threads = context.threads(), .progress = &context.progress()});
    requireFinite(rendering);
    return developed(mapper, rendering);
}

}  // namespace

void drawPhotonMaps(FigureContext& context) {
    const std::int64_t passes = context.byQuality(8, 100);
    const int scale = context.byQuality(4, 1);
    const Scene scene(CausticScene{.lampSide = 0.2}.beforeMirror(width / scale, height / scale));
    SppmSettings settings = namedScene("caustic_mirror").settings;
    settings.photons = photonsAPass;
    context.progress().expect(2 * pictureSteps);
    const std::string photons = std::to_string(passes * photonsAPass / 1000) + " thousand photons";
    drawTiles({{"photon mapping: " + photons + " in one map",
                [&](int, int) { return toneMapped(oneMap(scene, settings, passes, context), 1, 4); }},
               {"SPPM: " + photons + " in " + std::to_string(passes) + " passes",
                [&](int, int) { return toneMapped(sppmPicture(scene, settings, passes, context), 1, 4); }}},
              width, height, "photon_maps.png", context);
}

}  // namespace caustic
