#include <string>

#include "camera/box_filter.h"
#include "figure/quantities.h"
#include "figures.h"
#include "image/picture_error.h"
#include "integrator/ray_count_rows.h"
#include "integrator/render.h"
#include "measures/convergence_points.h"
#include "measures/measured_scenes.h"
#include "measures/missing_light.h"
#include "measures/needs_command.h"
#include "measures/radiosity.h"
#include "modeler/diffuse_box.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

void addSlopes(CsvTable& table, const ConvergencePoints& all) {
    for (const MeasuredScene& scene : measuredScenes()) {
        for (const Method method : allMethods)
            table.addRow(nameOf(method), "slope: " + scene.title, slopeOf(pointsOf(all, scene.name, method)),
                         "of log error over log samples", "-0.5 without bias");
    }
}

// What halving the patches changes; its own error is about a third of that.
void addReferenceErrors(CsvTable& table, FigureContext& context) {
    for (const bool mirror : {false, true}) {
        const DiffuseBox box = mirror ? smallLampBox() : DiffuseBox{};
        const SceneDescription scene = box.scene(32, 32);
        const auto picture = [&](int patches) {
            return BoxRadiosity(box, patches, context.threads()).picture(*scene.camera, 16, context.threads());
        };
        table.addRow("radiosity", mirror ? "own error: box with small lamp and mirror" : "own error: diffuse box",
                     rmse(picture(10), picture(20)) / 3, "radiance (rms)",
                     "half as many patches an edge; second order");
    }
}

void addCounts(CsvTable& table, FigureContext& context) {
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    for (const NeedyScene& needy : needyScenes()) {
        const Scene scene(needy.make());
        const std::string where = "up to " + needy.name + ": ";
        for (const Method method : {Method::Mis, Method::Light, Method::Bidirectional}) {
            const auto integrator = makeIntegrator(method, scene, sampler, filter, 10);
            const RayCounts counts = render(*integrator, {.passes = 4, .threads = context.threads()}).counts;
            addRayCounts(table, nameOf(method), where, counts, 4 * 32 * 32);
        }
    }
}

}  // namespace

void tabulateQuantities(ChapterRuns& runs, FigureContext& context) {
    writeQuantities({[&](CsvTable& table) { addSlopes(table, runs.convergence(context)); },
                     [&](CsvTable& table) { addReferenceErrors(table, context); },
                     [&](CsvTable& table) {
                         for (const MissingLight& one : missingLight(context.byQuality(64, 1024), context))
                             table.addRow(nameOf(one.method),
                                          "point lamp: light that is missing of a caustic before a mirror", one.percent,
                                          "percent of the picture's light",
                                          "bidirectional path tracing, a small ball for the lamp");
                     },
                     [&](CsvTable& table) { addCounts(table, context); },
                     [&](CsvTable& table) {
                         table.addRow("all methods", "samples of convergence.png that are no finite numbers",
                                      static_cast<Real>(runs.bad()), "of " + std::to_string(runs.samples()), "0");
                     }},
                    context);
}

}  // namespace caustic
