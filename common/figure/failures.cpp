#include "figure/failures.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/progress.h"
#include "figure/csv_table.h"
#include "figure/gnuplot.h"

namespace caustic {

namespace {

void save(const std::vector<FailureRow>& rows, FigureContext& context) {
    CsvTable table({"method", "case", "failures", "trials"});
    for (const FailureRow& row : rows) table.addRow(row.method, row.name, row.failures, row.trials);
    table.save(context.output("failure.csv"));
}

}  // namespace

std::vector<FailureRow> countFailures(const std::vector<FailureKind>& kinds, const FailureTrials& trials) {
    if (trials.progress != nullptr) trials.progress->expect(static_cast<std::int64_t>(kinds.size()));
    std::vector<FailureRow> rows;
    for (const FailureKind& kind : kinds) {
        std::vector<std::vector<bool>> verdicts(static_cast<std::size_t>(trials.count));
        parallelFor(trials.count, trials.threads, [&](std::int64_t i) {
            Random random(trials.seed, {static_cast<std::uint64_t>(i)});
            verdicts[static_cast<std::size_t>(i)] = kind.right(random);
        });
        for (std::size_t k = 0; k < kind.methods.size(); ++k) {
            FailureRow row = {kind.methods[k].name, kind.name, 0, trials.count, kind.methods[k].robust};
            for (const std::vector<bool>& right : verdicts) row.failures += right.at(k) ? 0 : 1;
            rows.push_back(row);
        }
        if (trials.progress != nullptr) trials.progress->advance();
    }
    return rows;
}

std::vector<bool> within(double tolerance, double truth, std::initializer_list<double> answers) {
    std::vector<bool> right;
    for (const double answer : answers) right.push_back(std::abs(answer - truth) <= tolerance);
    return right;
}

void drawFailureBars(const std::vector<FailureRow>& rows, FigureContext& context) {
    save(rows, context);
    context.sharedChart("failure_bars.gp", "failure.png");
}

void drawFailureMarks(const std::vector<FailureRow>& rows, FigureContext& context) {
    save(rows, context);
    std::vector<std::string> fragile;
    for (const FailureRow& row : rows) {
        if (!row.robust && std::find(fragile.begin(), fragile.end(), row.method) == fragile.end())
            fragile.push_back(row.method);
    }
    std::string settings = "array fragile[" + std::to_string(fragile.size()) + "]";
    for (std::size_t i = 0; i < fragile.size(); ++i)
        settings += "; fragile[" + std::to_string(i + 1) + "] = " + gnuplotString(fragile[i]);
    context.sharedChart("failure_marks.gp", "failure.png", settings);
}

}  // namespace caustic
