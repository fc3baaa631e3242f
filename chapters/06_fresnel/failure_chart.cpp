#include "core/csv_table.h"
#include "failure_cases.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    CsvTable table({"method", "case", "failures", "trials"});
    for (const FailureRow& row : failureRows(2000, context.seed()))
        table.addRow(row.method, row.name, row.failures, row.trials);
    table.save(context.output("failure.csv"));
    context.chart("failure.gp", "failure.png");
}

}  // namespace caustic
