#include <array>
#include <string>

#include "core/progress.h"
#include "failures/root_examination.h"
#include "figure/csv_table.h"
#include "figures.h"

namespace caustic {

void tabulateQuantities(FigureContext& context) {
    const auto revolutionSets = revolutionSetNames();
    context.progress().expect(static_cast<std::int64_t>(revolutionSets.size()));
    const std::int64_t rays = context.byQuality<std::int64_t>(800, 8'000);
    CsvTable table({"method", "case", "value", "unit", "reference"});
    for (std::size_t set = 0; set < revolutionSets.size(); ++set) {
        const RootExamination count = examineRevolution(set, rays, context.seed(), context.threads());
        table.addRow("robust", "rays in the band of tangency: " + revolutionSets[set],
                     100.0 * static_cast<double>(count.raysInBand) / static_cast<double>(count.rays), "%",
                     "cosine below 1e-5, open borders, cusps");
        table.addRow("robust", "worst |L(t) - B|: " + revolutionSets[set], count.worstDistance,
                     "of the size and the origin's distance", "1e-12");
        context.progress().advance();
    }
    table.save(context.output("quantity.csv"));
}

}  // namespace caustic
