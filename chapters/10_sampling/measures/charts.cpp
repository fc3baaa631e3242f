#include <cmath>

#include "figure/csv_table.h"
#include "figures.h"

namespace caustic {

void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (const SamplerPoint& point : runs.samplers(context))
        table.addRow(point.sampler, "scene=" + point.scene + ";samples=" + std::to_string(point.samples), point.seconds,
                     "s", point.error, "radiance (rms)");
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

void chartAdaptive(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "error", "error_unit", "samples_gain", "samples_gain_error", "time_gain",
                    "time_gain_error", "worst_gain", "worst_gain_error", "bias", "bias_error", "time", "time_unit"});
    for (const AdaptivePoint& one : runs.adaptive(context))
        table.addRow(one.method, "scene=" + one.scene + ";paths=" + std::to_string(one.paths),
                     std::sqrt(one.noise.variance.value), "radiance (standard deviation)", one.samplesGain.value,
                     one.samplesGain.error, one.timeGain.value, one.timeGain.error, one.worstGain.value,
                     one.worstGain.error, one.bias.value, one.bias.error, one.noise.seconds, "s");
    table.save(context.output("adaptive.csv"));
    context.chart("measures/adaptive.gp", "adaptive.png");
}

}  // namespace caustic
