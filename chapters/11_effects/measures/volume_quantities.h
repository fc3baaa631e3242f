#pragma once

#include "figure/csv_table.h"
#include "figure/figure.h"

namespace caustic {

/// Rows of quantity.csv: single scattering against its closed form, and what a tree spares whoever gathers along a ray.
void addVolumeQuantities(CsvTable& table, FigureContext& context);

}  // namespace caustic
