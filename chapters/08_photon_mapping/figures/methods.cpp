#include <string>

#include "camera/box_filter.h"
#include "core/progress.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "image/image_file.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "picture.h"
#include "sampling/independent_sampler.h"
#include "work.h"

namespace caustic {

namespace {

Tile tileOf(const std::string& caption, const Image& picture) {
    return {caption, [picture](int, int) { return toneMapped(picture, 1, 4); }};
}

}  // namespace

void drawMethods(const ChapterInputs& chapter, FigureContext& context) {
    const Scene scene(causticBeforeMirror());
    const Image reference = loadImage(context.asset("assets/references/caustic_mirror.exr"));
    const CausticWork work = causticWork(chapter, context.quality());
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    context.progress().expect(3 * progressSteps);
    CsvTable table({"method", "case", "samples", "photons"});
    std::vector<Tile> tiles;
    const auto add = [&](const std::string& name, Integrator& integrator, std::int64_t samples, std::int64_t photons) {
        const Image picture = renderImage(integrator, samples, context, &context.progress());
        table.addRow(name, "caustic before a mirror", samples, photons);
        tiles.push_back(tileOf(name, picture));
    };
    PathTracer paths(scene, sampler, filter, {{CausticWork::segments, 1}, Direct::Mis});
    add("path tracing with MIS", paths, work.pathSamples, 0);
    BidirectionalPathTracer both(scene, sampler, filter, {CausticWork::segments, 1});
    add("bidirectional path tracing", both, work.bidirectionalSamples, 0);
    PhotonMapper mapper(scene, sampler, filter, causticSettings(work.photons), context.threads());
    add("photon mapping", mapper, work.photonSamples, work.photons);
    tiles.push_back(tileOf("bidirectional, very much longer", reference));
    table.save(context.output("methods.csv"));
    drawTiles(tiles, 2 * CausticWork::width, 2 * CausticWork::height, "methods.png", context, 2);
}

}  // namespace caustic
