#include "figures/equal_time.h"

#include <cstdio>

#include "camera/box_filter.h"
#include "core/progress.h"
#include "figure/csv_table.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/near_lamps.h"
#include "integrator/picture.h"
#include "measures/measured_scenes.h"
#include "modeler/caustic_scene.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

std::string rounded(Real value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

Tile shown(const std::string& caption, const Image& picture, Real exposure) {
    return {caption, [picture, exposure](int, int) { return toneMapped(picture, exposure, 4); }};
}

// The five pictures and the converged one, in two rows, and their errors as a table.
void drawEqualTime(const EqualTimePicture& what, ChapterRuns& runs, FigureContext& context) {
    const WorkCounts work = runs.work();
    const Scene scene(what.make());
    const Image converged = loadImage(context.asset(what.asset));
    const std::vector<bool> leftOut = pixelsNearLamps(scene, 2);
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    std::vector<Tile> tiles;
    CsvTable table({"method", "case", "samples", "error", "error_unit"});
    context.progress().expect(static_cast<std::int64_t>(allMethods.size()) * progressSteps);
    for (const Method method : allMethods) {
        const std::int64_t samples = work.samples(what.name, method, context.quality());
        const auto integrator = makeIntegrator(method, scene, sampler, filter, what.mostSegments);
        const Image picture = renderImage(*integrator, samples, context, &context.progress());
        const Real error = rmse(picture, converged, leftOut);
        table.addRow(nameOf(method), what.name, samples, error, "radiance (rms)");
        tiles.push_back(shown(nameOf(method) + ": " + rounded(error), picture, what.exposure));
    }
    tiles.push_back(shown(what.converged, converged, what.exposure));
    table.save(context.output(what.name + ".csv"));
    drawTiles(tiles, 400, 400 * what.height / what.width, what.name + ".png", context, 3);
}

}  // namespace

const std::vector<EqualTimePicture>& equalTimePictures() {
    static const std::vector<EqualTimePicture> pictures = {
        {"methods", 256, 256, peersBoxSegments, 1, [] { return peersBox(256, 256); }, "assets/references/peers_box.exr",
         "converged"},
        {"caustic", 200, 150, 16, 1, [] { return CausticScene{.lampSide = 0.2}.beforeMirror(200, 150); },
         "assets/references/caustic_mirror.exr", "bidirectional, far longer"}};
    return pictures;
}

void drawMethods(ChapterRuns& runs, FigureContext& context) { drawEqualTime(equalTimePictures()[0], runs, context); }

void drawCaustic(ChapterRuns& runs, FigureContext& context) { drawEqualTime(equalTimePictures()[1], runs, context); }

}  // namespace caustic
