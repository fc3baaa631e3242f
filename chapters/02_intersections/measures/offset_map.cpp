#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contact_scene.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "core/text.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "math/spawn.h"

namespace caustic {

namespace {

// Exponents of ten.
struct Range {
    double first;
    double last;
    double step;

    int count() const { return static_cast<int>(std::lround((last - first) / step)) + 1; }
    double at(int i) const { return first + i * step; }
};

template <typename Scalar>
void addPrecision(CsvTable& table, const std::string& name, FigureContext& context) {
    const double step = context.byQuality(0.5, 0.25);
    const Range scales = {-4, 7, step};
    const Range offsets = {-16, 2, step};
    constexpr int rays = 1000;
    std::vector<ContactFailures> counts(static_cast<std::size_t>(scales.count() * offsets.count()));
    parallelFor(scales.count() * offsets.count(), context.threads(), [&](std::int64_t i) {
        const double scale = std::pow(10, scales.at(static_cast<int>(i) / offsets.count()));
        const double offset = std::pow(10, offsets.at(static_cast<int>(i) % offsets.count()));
        counts[static_cast<std::size_t>(i)] =
            contactFailures<Scalar>(scale, {static_cast<Scalar>(offset), 0}, rays, context.seed());
        context.progress().advance();
    });
    // The rule's own distance, at the touching point, for the same number of epsilons in either precision.
    const double relative = surfaceOffset / std::numeric_limits<Real>::epsilon() *
                            static_cast<double>(std::numeric_limits<Scalar>::epsilon());
    for (int i = 0; i < scales.count(); ++i) {
        const double scale = std::pow(10, scales.at(i));
        const ContactScene<Scalar> scene(static_cast<Scalar>(scale));
        const double rule = relative * static_cast<double>(scene.floorPoint(scene.touch()).magnitude);
        for (int j = 0; j < offsets.count(); ++j) {
            const ContactFailures& count = counts[static_cast<std::size_t>(i * offsets.count() + j)];
            table.addRow(name, "size 1e" + formatReal(scales.at(i)) + ", distance 1e" + formatReal(offsets.at(j)),
                         scales.at(i), offsets.at(j), count.selfHits.failures, count.lostContacts.failures, rays,
                         std::log10(rule));
        }
    }
}

}  // namespace

void chartOffsets(FigureContext& context) {
    context.progress().expect(context.byQuality(2 * 23 * 37, 2 * 45 * 73));
    CsvTable table(
        {"method", "case", "log10_scale", "log10_offset", "self_hits", "lost_contacts", "trials", "log10_rule"});
    addPrecision<float>(table, "float", context);
    addPrecision<double>(table, "double", context);
    table.save(context.output("offset_map.csv"));
    context.chart("measures/offset_map.gp", "offset_map.png");
}

}  // namespace caustic
