#include "figure/csv_table.h"
#include "figures.h"

namespace caustic {

void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (const SamplerPoint& point : runs.samplers(context))
        table.addRow(point.sampler, "scene=" + point.scene + ";samples=" + std::to_string(point.samples),
                     point.seconds, "s", point.error, "radiance (rms)");
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

void chartConvergence(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "error", "error_unit"});
    for (const SamplerPoint& point : runs.samplers(context))
        table.addRow(point.sampler, "scene=" + point.scene + ";samples=" + std::to_string(point.samples), point.error,
                     "radiance (rms)");
    table.save(context.output("convergence.csv"));
    context.chart("measures/convergence.gp", "convergence.png");
}

}  // namespace caustic
