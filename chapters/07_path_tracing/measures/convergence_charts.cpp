#include <utility>

#include "figure/csv_table.h"
#include "figures.h"
#include "measures/measured_scenes.h"

namespace caustic {

namespace {

std::string settingOf(const ConvergencePoint& point) {
    return "scene=" + point.scene + ";samples=" + std::to_string(point.samples);
}

// Who is how much better after the same time.
void tabulateRatios(const ConvergencePoints& all, FigureContext& context) {
    constexpr std::pair<Method, Method> pairs[] = {
        {Method::Light, Method::Chance}, {Method::Light, Method::Direct}, {Method::Bidirectional, Method::Mis}};
    CsvTable table({"method", "case", "value", "unit", "reference"});
    for (const MeasuredScene& scene : measuredScenes()) {
        for (const auto& [one, other] : pairs)
            table.addRow(nameOf(one), scene.title + ": error at equal time over that of " + nameOf(other),
                         errorRatio(all, scene.name, one, other), "1", scene.judge);
    }
    table.save(context.output("equal_time.csv"));
}

}  // namespace

void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (const ConvergencePoint& point : runs.convergence(context)) {
        table.addRow(nameOf(point.method), settingOf(point), point.seconds, "s", point.error, "radiance (rms)");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
    tabulateRatios(runs.convergence(context), context);
}

void chartConvergence(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "error", "error_unit"});
    for (const ConvergencePoint& point : runs.convergence(context))
        table.addRow(nameOf(point.method), settingOf(point), point.error, "radiance (rms)");
    table.save(context.output("convergence.csv"));
    context.chart("measures/convergence.gp", "convergence.png");
}

}  // namespace caustic
