#include "core/progress.h"
#include "failures/failure_cases.h"
#include "figure/csv_table.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    const std::vector<FailureProbe> probes = failureProbes();
    context.progress().expect(static_cast<std::int64_t>(probes.size()));
    CsvTable table({"method", "case", "failures", "trials"});
    for (const FailureProbe& probe : probes) {
        table.addRow(probe.method, probe.name, countFailures(probe, context.seed(), context.threads()), failureTrials);
        context.progress().advance();
    }
    table.save(context.output("failure.csv"));
    context.chart("failures/failure.gp", "failure.png");
}

}  // namespace caustic
