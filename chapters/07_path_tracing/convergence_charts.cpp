#include "core/csv_table.h"
#include "figures.h"
#include "measured_scenes.h"

namespace caustic {

namespace {

std::string settingOf(const ConvergencePoint& point) {
    return "scene=" + point.scene + ";samples=" + std::to_string(point.samples);
}

}  // namespace

void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (const ConvergencePoint& point : runs.convergence(context)) {
        table.addRow(nameOf(point.method), settingOf(point), point.seconds, "s", point.error, "radiance (rms)");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("speed_accuracy.gp", "speed_accuracy.png");
}

void chartConvergence(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "error", "error_unit"});
    for (const ConvergencePoint& point : runs.convergence(context))
        table.addRow(nameOf(point.method), settingOf(point), point.error, "radiance (rms)");
    table.save(context.output("convergence.csv"));
    context.chart("convergence.gp", "convergence.png");
}

}  // namespace caustic
