#include "camera/box_filter.h"
#include "core/progress.h"
#include "figures.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/render.h"
#include "math/spawn.h"
#include "modeler/peers_box.h"
#include "picture.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr int shownSide = 420;

// Some of the photons, those that are in view, as dots in the colour of their power.
Image photonsAsDots(const Scene& scene, std::span<const Photon> photons, int side) {
    Image dots(side, side);
    // Places in the tree say nothing of the order in which photons came: every n-th is a fair choice.
    const std::size_t step = photons.size() / static_cast<std::size_t>(side * side / 2) + 1;
    for (std::size_t i = 0; i < photons.size(); i += step) {
        const Photon& photon = photons[i];
        const auto seen = scene.camera().sampleImportance(photon.point, {0.5, 0.5});
        if (!seen) continue;
        // A hair's breadth before the surface, or it would hide its own photons.
        const Ray way = {photon.point, seen->wi, 1e-4 * seen->distance, seen->distance};
        RayCounts counts;
        if ((scene.transmittance(way, {}, counts) == 0).all()) continue;
        const auto x = static_cast<int>(seen->film.x());
        const auto y = static_cast<int>(seen->film.y());
        if (x < 0 || x >= side || y < 0 || y >= side) continue;
        dots.set(x, y, (dots.at(x, y) + 0.4 * photon.power / photon.power.maxCoeff()).min(1));
    }
    return dots;
}

}  // namespace

void drawPhotonMap(FigureContext& context) {
    const int side = context.byQuality(shownSide / 2, shownSide);
    const Scene scene(peersBox(side, side));
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    PhotonMapperSettings settings;
    settings.photons = context.byQuality(50'000, 200'000);
    settings.limits.maxLength = peersBoxSegments;
    settings.use = MapUse::Everything;
    settings.density = {.nearest = 100, .radius = 0.2};
    context.progress().expect(2 * progressSteps);
    PhotonMapper alone(scene, sampler, filter, settings, context.threads());
    const Image dots = photonsAsDots(scene, alone.map().photons(), side);
    const Image looked = renderImage(alone, context.byQuality(1, 4), context, &context.progress());
    settings.use = MapUse::Indirect;
    settings.caustics = {.nearest = 60, .radius = 0.05};
    const Image sampled = photonPicture(scene, settings, context.byQuality(1, 9), context);
    const auto tile = [](const std::string& caption, const Image& picture) {
        return Tile{caption, [picture](int, int) { return picture; }};
    };
    drawTiles({tile("photons where they lie", dots), tile("as light, and nothing else", toneMapped(looked, 1, 4)),
               tile("with direct light sampled", toneMapped(sampled, 1, 4))},
              shownSide, shownSide, "photon_map.png", context, 3);
}

}  // namespace caustic
