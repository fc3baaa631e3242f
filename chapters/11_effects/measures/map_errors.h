#pragma once

#include "figure/csv_table.h"
#include "figure/figure.h"

namespace caustic {

/// Rows of speed_accuracy.csv: the light of a sky with a small sun by four choices of directions, and the size of a
/// point out of focus by points of the lens, random and stratified.
void addMapErrors(CsvTable& table, FigureContext& context);

}  // namespace caustic
