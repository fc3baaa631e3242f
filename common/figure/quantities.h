#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/progress.h"
#include "figure/csv_table.h"
#include "figure/figure.h"

namespace caustic {

/// A part of quantity.csv: adds rows of method, case, value, unit and what the value is to be compared with.
using QuantityPart = std::function<void(CsvTable&)>;

/// Writes quantity.csv, what a lesson states and no chart shows: the rows of each part in turn. The progress advances
/// with each.
inline void writeQuantities(const std::vector<QuantityPart>& parts, FigureContext& context) {
    context.progress().expect(static_cast<std::int64_t>(parts.size()));
    CsvTable table({"method", "case", "value", "unit", "reference"});
    for (const QuantityPart& part : parts) {
        part(table);
        context.progress().advance();
    }
    table.save(context.output("quantity.csv"));
}

}  // namespace caustic
