#include <cmath>
#include <functional>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "image/picture_error.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "measures/floor_caustic.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr int repetitions = 3;
constexpr int longest = 64;     // segments: as good as no end
constexpr int eyePaths = 4;     // a pixel
constexpr Real farthest = 0.3;  // m: where photons are few, they aren't looked for any farther

// A method: what it is called, and the picture that it takes with so much work.
struct Measured {
    std::string name;
    std::string setting;  // what the work is
    std::vector<std::int64_t> work;
    std::function<FloorCaustic::Taken(std::int64_t work, std::uint64_t seed)> take;
};

Measured byPhotons(const FloorCaustic& floor, const std::string& name, const DensitySettings& density,
                   const std::vector<std::int64_t>& work) {
    return {name, "photons", work, [&floor, density](std::int64_t photons, std::uint64_t seed) {
                PhotonMapperSettings settings = {.photons = photons, .limits = {longest, 1}};
                settings.density = density;
                settings.caustics = density;
                return floor.byPhotons(settings, eyePaths, seed);
            }};
}

FloorCaustic::Taken timed(Integrator& integrator, std::int64_t samples) {
    const Rendering rendering = render(integrator, {.passes = samples});
    return {rendering.film.image(), rendering.seconds};
}

std::vector<Measured> methods(const FloorCaustic& floor, FigureContext& context) {
    std::vector<std::int64_t> photons = {2'000, 8'000, 32'000};
    std::vector<std::int64_t> paths = {1, 4, 16};
    if (context.quality() == Quality::Report) {
        photons.insert(photons.end(), {128'000, 512'000, 2'048'000});
        paths.insert(paths.end(), {64, 256});
    }
    const Scene& scene = floor.scene();
    static const BoxFilter filter;
    return {byPhotons(floor, "20 nearest photons", {.nearest = 20, .radius = farthest}, photons),
            byPhotons(floor, "100 nearest photons", {.nearest = 100, .radius = farthest}, photons),
            byPhotons(floor, "100 nearest with cone filter", {.nearest = 100, .radius = farthest, .cone = 1}, photons),
            byPhotons(floor, "photons within 3 cm", {.nearest = {}, .radius = 0.03}, photons),
            {"path tracing with MIS", "samples", paths,
             [&scene](std::int64_t samples, std::uint64_t seed) {
                 const IndependentSampler sampler(seed);
                 PathTracer tracer(scene, sampler, filter, {{longest, 1}, Direct::Mis});
                 return timed(tracer, samples);
             }},
            {"bidirectional path tracing", "samples", paths, [&scene](std::int64_t samples, std::uint64_t seed) {
                 const IndependentSampler sampler(seed);
                 BidirectionalPathTracer tracer(scene, sampler, filter, {longest, 1});
                 return timed(tracer, samples);
             }}};
}

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    const FloorCaustic floor(context);
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    const std::vector<Measured> all = methods(floor, context);
    context.progress().expect(static_cast<std::int64_t>(all.size()));
    struct Row {
        double seconds = 0;
        Real squares = 0;
    };
    std::vector<std::vector<Row>> rows(all.size());
    parallelFor(static_cast<std::int64_t>(all.size()), context.threads(), [&](std::int64_t item) {
        const auto at = static_cast<std::size_t>(item);
        for (const std::int64_t work : all[at].work) {
            Row row;
            for (std::uint64_t i = 0; i < repetitions; ++i) {
                const FloorCaustic::Taken taken = all[at].take(work, context.seed() + 1000 * at + i);
                row.seconds += taken.seconds / repetitions;
                const Real error = rmse(taken.picture, floor.reference());
                row.squares += error * error / repetitions;
            }
            rows[at].push_back(row);
        }
        context.progress().advance();
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < rows[i].size(); ++j)
            table.addRow(all[i].name, all[i].setting + "=" + std::to_string(all[i].work[j]), rows[i][j].seconds, "s",
                         std::sqrt(rows[i][j].squares), "radiance (rms)");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
