#include "figure/csv_table.h"
#include "figures.h"

namespace caustic {

void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (const ErrorPoint& point : runs.mirrorErrors(context))
        table.addRow(nameOf(point.method), "passes=" + std::to_string(point.passes), point.seconds, "s", point.error,
                     "radiance (rms)");
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

void chartClaims(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "error", "error_unit"});
    for (const ErrorPoint& point : runs.mirrorErrors(context)) {
        if (point.method != Method::Pass && point.method != Method::Point) continue;
        const std::string passes = ";passes=" + std::to_string(point.passes);
        table.addRow(nameOf(point.method), "part=caustic" + passes, point.bright, "share of the radiance (rms)");
        table.addRow(nameOf(point.method), "part=dark" + passes, point.dark, "share of the radiance (rms)");
    }
    table.save(context.output("claims.csv"));
    context.chart("measures/claims.gp", "claims.png");
}

void chartBias(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "error", "error_unit"});
    for (const BiasCurve& curve : runs.bias(context)) {
        for (std::size_t i = 0; i < curve.passes.size(); ++i)
            table.addRow(curve.method,
                         "alpha=" + formatReal(curve.alpha) + ";passes=" + std::to_string(curve.passes[i]),
                         curve.bias[i], "share of the radiance");
    }
    table.save(context.output("bias.csv"));
    context.chart("measures/bias.gp", "bias.png");
}

void chartRadius(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "smallest", "lower", "median", "upper", "largest", "unit"});
    for (const PassState& state : runs.passStates(context)) {
        const auto& r = state.radii;
        table.addRow(nameOf(state.method), "passes=" + std::to_string(state.passes), r[0], r[1], r[2], r[3], r[4], "m");
    }
    table.save(context.output("radius.csv"));
    context.chart("measures/radius.gp", "radius.png");
}

void chartMemory(ChapterRuns& runs, FigureContext& context) {
    CsvTable table({"method", "setting", "memory", "memory_unit"});
    for (const PassState& state : runs.passStates(context))
        table.addRow(nameOf(state.method), "passes=" + std::to_string(state.passes), state.memory, "MiB");
    table.save(context.output("memory.csv"));
    context.chart("measures/memory.gp", "memory.png");
}

}  // namespace caustic
