#include "failures/failure_cases.h"
#include "figure/csv_table.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    CsvTable table({"method", "case", "failures", "trials"});
    for (const FailureRow& row : failureRows(2000, context.seed()))
        table.addRow(row.method, row.name, row.failures, row.trials);
    table.save(context.output("failure.csv"));
    context.chart("failures/failure.gp", "failure.png");
}

}  // namespace caustic
