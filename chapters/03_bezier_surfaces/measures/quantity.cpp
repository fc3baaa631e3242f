#include <array>
#include <string>

#include "failures/root_examination.h"
#include "figure/quantities.h"
#include "figures.h"

namespace caustic {

void tabulateQuantities(FigureContext& context) {
    const auto revolutionSets = revolutionSetNames();
    const std::int64_t rays = context.byQuality<std::int64_t>(800, 8'000);
    std::vector<QuantityPart> parts;
    for (std::size_t set = 0; set < revolutionSets.size(); ++set) {
        parts.push_back([&, set](CsvTable& table) {
            const RootExamination count = examineRevolution(set, rays, context.seed(), context.threads());
            table.addRow("robust", "rays in the band of tangency: " + revolutionSets[set],
                         100.0 * static_cast<double>(count.raysInBand) / static_cast<double>(count.rays), "%",
                         "cosine below 1e-5, open borders, cusps");
            table.addRow("robust", "worst |L(t) - B|: " + revolutionSets[set], count.worstDistance,
                         "of the size and the origin's distance", "1e-12");
        });
    }
    writeQuantities(parts, context);
}

}  // namespace caustic
