#include "figure/quantities.h"

#include <algorithm>
#include <cmath>

#include "camera/box_filter.h"
#include "figure/timing.h"
#include "figures.h"
#include "importance.h"
#include "integrator/render.h"
#include "measures/lit_floor.h"
#include "measures/photon_pattern.h"
#include "sampling/independent_sampler.h"
#include "sampling/sampler_names.h"
#include "work.h"

namespace caustic {

namespace {

void addSlopes(CsvTable& table, ChapterRuns& runs, FigureContext& context) {
    for (const std::string& name : samplerNames()) {
        table.addRow(name, "slope of the error over paths, smooth floor",
                     slopeOf(runs.samplers(context), "smooth", name), "", name == "random" ? "-0.5" : "");
    }
    for (const std::string& name : samplerNames())
        table.addRow(name, "slope of the error over paths, caustic", slopeOf(runs.samplers(context), "caustic", name),
                     "", "-0.5");
}

// What a pair of numbers costs.
void addCosts(CsvTable& table, FigureContext& context) {
    std::vector<std::unique_ptr<const Sampler>> samplers;
    std::vector<std::function<void()>> pieces;
    for (const std::string& name : samplerNames()) samplers.push_back(makeSampler(name, context.seed(), 256));
    std::int64_t index = 0;
    for (const auto& sampler : samplers)
        pieces.push_back([&index, &sampler] {
            keep(sampler->start(0, {3, 4}, ++index % 4096).pair(Dimension::film()));
        });
    const std::vector<double> times = medianNanoseconds(pieces, {});
    for (std::size_t i = 0; i < times.size(); ++i)
        table.addRow(samplerNames()[i], "a pair of numbers", times[i], "ns", "");
}

// Errors of the photons' density at low frequencies, and the largest of all waves.
void addSpectra(CsvTable& table, FigureContext& context) {
    const auto ways = emissions(context.seed());
    Real random = 0;
    for (const Emission& way : ways) {
        const auto spectrum = PhotonPattern(*way.sampler, 256, 0, context.threads()).spectrum();
        if (random == 0) random = spectrum.low;
        table.addRow(
            way.name,
            "50,000 photons: error at 1 to " + std::to_string(PhotonPattern::lowest) + " periods across the picture",
            std::sqrt(spectrum.low / random), "of random photons'", way.name == "random" ? "1" : "at most 1/3");
        table.addRow(way.name, "50,000 photons: spectral peak, largest power of any frequency", spectrum.peak,
                     "of random photons' mean", "");
    }
}

// Error of four rays a pixel by each density, near the lamp and far from it.
void addImportance(CsvTable& table, FigureContext& context) {
    constexpr int width = 48;
    const LitFloor floor = LitFloor::beside(width);
    const Image truth = floor.truth();
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    for (const Importance density : {Importance::Uniform, Importance::Cosine, Importance::Lamp, Importance::Both}) {
        ImportanceTracer tracer(floor.scene(), sampler, filter, density);
        const std::int64_t passes = context.byQuality(4, 64);
        const Image picture = render(tracer, {.passes = passes, .threads = context.threads()}).film.image();
        const auto error = [&](int from, int to) {
            Real squares = 0;
            Real truths = 0;
            for (int y = 0; y < width; ++y) {
                for (int x = from; x < to; ++x) {
                    squares += (picture.at(x, y) - truth.at(x, y)).square().sum();
                    truths += truth.at(x, y).square().sum();
                }
            }
            // As of one ray: errors of n rays go with 1/√n.
            return std::sqrt(squares / truths * static_cast<Real>(passes));
        };
        const std::string unit = "of the radiance (rms), one ray";
        table.addRow(nameOf(density), "error near the lamp", error(0, width / 8), unit, "");
        table.addRow(nameOf(density), "error far from it", error(3 * width / 4, width), unit, "");
        table.addRow(nameOf(density), "error, whole picture", error(0, width), unit, "");
    }
}

// How far an adaptive picture's mean is off, and what cures it.
void addBias(CsvTable& table, FigureContext& context) {
    const int seeds = context.byQuality(3, 12);
    const int width = context.byQuality(16, 24);
    const auto rule = [](const Scene&) { return std::make_unique<IntervalRule>(0.05); };
    const std::vector<Taking> ways = {
        {"uniform", {}, {}, context.byQuality(64, 512)},
        {"③ from 4 paths on, each pixel by itself",
         rule,
         {.batch = 1, .first = 4, .most = 512, .share = 1, .spread = 0},
         0},
        {"③ from 16 paths on, in batches of 4",
         rule,
         {.batch = 4, .first = 16, .most = 512, .share = 1, .spread = 0},
         0},
        {"③ from 16 paths on, with neighbours", rule, {.batch = 4, .first = 16, .most = 512, .share = 1}, 0},
        {"③ from 64 paths on, with neighbours", rule, {.batch = 16, .first = 64, .most = 512, .share = 1}, 0},
        {"③ decided by paths that don't count",
         rule,
         {.batch = 4, .first = 32, .most = 512, .share = 1, .apart = true},
         0}};
    const std::vector<PictureNoise> noises = noiseOf(study("bunny"), width, ways, seeds, context);
    for (std::size_t i = 1; i < ways.size(); ++i) {
        const Measurement share = ratio(noises[i].mean, noises[0].mean);
        table.addRow(ways[i].method, "bunny: the picture's mean is off by", 100 * (share.value - 1), "%",
                     "0, standard error " + formatReal(std::round(1e4 * share.error) / 100));
        table.addRow(ways[i].method, "bunny: paths", noises[i].paths, "a pixel", "");
    }
}

// What the report's figures are counts of: paths where the picture is hard over those where it is easy.
void addPathCounts(CsvTable& table, FigureContext& context) {
    constexpr int width = 100;
    const Study& what = study("bunny");
    PictureWork work = pictureWork("bunny", context.quality());
    work.settings.paths = work.settings.paths / work.width * width / work.width * width;
    const Scene scene = what.scene(assetOf(what, context), width);
    const IndependentSampler sampler(context.seed());
    const auto inner = what.method(scene, sampler);
    const IntervalRule rule(work.tolerance);
    AdaptiveIntegrator adaptive(*inner, sampler, rule, work.settings);
    renderAdaptively(adaptive, {.threads = context.threads()});
    std::vector<std::int64_t> counts;
    for (int y = 0; y < scene.camera().height(); ++y) {
        for (int x = 0; x < scene.camera().width(); ++x) counts.push_back(adaptive.paths({x, y}));
    }
    std::ranges::sort(counts);
    table.addRow("③ widest interval", "bunny: paths of the median pixel", counts[counts.size() / 2], "",
                 "the report: about 50 in regions of high density");
    table.addRow("③ widest interval", "bunny: paths of the hardest pixel", counts.back(), "",
                 "the report: over 1,000 in special places");
}

}  // namespace

void tabulateQuantities(ChapterRuns& runs, FigureContext& context) {
    writeQuantities(
        {[&](CsvTable& table) { addSlopes(table, runs, context); }, [&](CsvTable& table) { addCosts(table, context); },
         [&](CsvTable& table) { addSpectra(table, context); }, [&](CsvTable& table) { addImportance(table, context); },
         [&](CsvTable& table) { addBias(table, context); }, [&](CsvTable& table) { addPathCounts(table, context); }},
        context);
}

}  // namespace caustic
