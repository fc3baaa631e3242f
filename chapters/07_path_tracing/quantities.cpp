#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "camera/box_filter.h"
#include "core/csv_table.h"
#include "core/progress.h"
#include "figures.h"
#include "image/picture_error.h"
#include "measured_scenes.h"
#include "missing_light.h"
#include "modeler/diffuse_box.h"
#include "needs_command.h"
#include "radiosity.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

using Points = std::vector<ConvergencePoint>;

Points pointsOf(const Points& all, const std::string& scene, Method method) {
    Points own;
    std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                 [&](const ConvergencePoint& one) { return one.scene == scene && one.method == method; });
    return own;
}

// Least squares of log(error) over log(samples).
Real slopeOf(const Points& points) {
    Vec2 mean = Vec2::Zero();
    const auto place = [](const ConvergencePoint& one) {
        return Vec2(std::log(static_cast<Real>(one.samples)), std::log(one.error));
    };
    for (const ConvergencePoint& one : points) mean += place(one) / static_cast<Real>(points.size());
    Real xy = 0;
    Real xx = 0;
    for (const ConvergencePoint& one : points) {
        const Vec2 off = place(one) - mean;
        xy += off.x() * off.y();
        xx += off.x() * off.x();
    }
    return xy / xx;
}

// Error after so many seconds, between two points along a straight line of the logarithms.
Real errorAt(const Points& points, double seconds) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].seconds < seconds && i + 1 < points.size()) continue;
        const Real part =
            std::log(seconds / points[i - 1].seconds) / std::log(points[i].seconds / points[i - 1].seconds);
        return points[i - 1].error * std::pow(points[i].error / points[i - 1].error, part);
    }
    return points.back().error;
}

Real errorRatio(const Points& all, const std::string& scene, Method one, Method other) {
    const Points first = pointsOf(all, scene, one);
    const Points second = pointsOf(all, scene, other);
    const double seconds = std::min(first.back().seconds, second.back().seconds);
    return errorAt(first, seconds) / errorAt(second, seconds);
}

void addConvergence(CsvTable& table, const Points& all) {
    for (const MeasuredScene& scene : measuredScenes()) {
        for (const Method method : allMethods)
            table.addRow(nameOf(method), "slope: " + scene.title, slopeOf(pointsOf(all, scene.name, method)),
                         "of log error over log samples", "-0.5 without bias");
    }
    for (const MeasuredScene& scene : measuredScenes()) {
        const std::pair<Method, Method> pairs[] = {
            {Method::Light, Method::Chance}, {Method::Light, Method::Direct}, {Method::Bidirectional, Method::Mis}};
        for (const auto& [one, other] : pairs)
            table.addRow(nameOf(one), "error at equal time: " + scene.title, errorRatio(all, scene.name, one, other),
                         "times that of " + nameOf(other), scene.judge);
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
            const RayCounts counts = render(*integrator, 4, context.threads()).counts;
            const std::pair<const char*, std::int64_t> rows[] = {{"rays", counts.rays},
                                                                 {"shadow rays", counts.shadowRays},
                                                                 {"boundaries", counts.crossings},
                                                                 {"transmittances", counts.transmittances},
                                                                 {"texture look-ups", counts.textureLookups},
                                                                 {"lens samples", counts.lensSamples}};
            for (const auto& [what, number] : rows)
                table.addRow(nameOf(method), where + what, static_cast<Real>(number) / (4 * 32 * 32), "per path", "");
        }
    }
}

}  // namespace

void tabulateQuantities(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "case", "value", "unit", "reference"});
    addConvergence(table, runs.convergence(context));
    addReferenceErrors(table, context);
    for (const MissingLight& one : missingLight(context.byQuality(64, 2048), runs, context))
        table.addRow(nameOf(one.method), "point lamp: light that is missing of a caustic before a mirror", one.percent,
                     "percent of the picture's light", "bidirectional path tracing, a small ball for the lamp");
    addCounts(table, context);
    table.addRow("all methods", "samples of this run's figures that are no finite numbers",
                 static_cast<Real>(runs.bad()), "of " + std::to_string(runs.samples()), "0");
    table.save(context.output("quantity.csv"));
}

}  // namespace caustic
