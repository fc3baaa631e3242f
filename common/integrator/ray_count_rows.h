#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "figure/csv_table.h"
#include "math/real.h"
#include "scene/ray_counts.h"

namespace caustic {

/// Rows of quantity.csv: what a path asks of the scene, on average.
/// @param where  begins each row's case
/// @param paths  that were counted together, greater than 0
inline void addRayCounts(CsvTable& table, const std::string& method, const std::string& where, const RayCounts& counts,
                         Real paths) {
    const std::pair<const char*, std::int64_t> rows[] = {{"rays", counts.rays},
                                                         {"shadow rays", counts.shadowRays},
                                                         {"boundaries", counts.crossings},
                                                         {"transmittances", counts.transmittances},
                                                         {"texture look-ups", counts.textureLookups},
                                                         {"lens samples", counts.lensSamples}};
    for (const auto& [what, number] : rows)
        table.addRow(method, where + what, static_cast<Real>(number) / paths, "per path", "");
}

}  // namespace caustic
