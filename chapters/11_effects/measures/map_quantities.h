#pragma once

#include "figure/csv_table.h"
#include "figure/figure.h"

namespace caustic {

/// Rows of quantity.csv: an even sky on a diffuse ball, what sampling by brightness is worth, black pixels of dented
/// balls, the noise of caustics through raw and smoothed maps, the circle of confusion.
void addMapQuantities(CsvTable& table, FigureContext& context);

}  // namespace caustic
