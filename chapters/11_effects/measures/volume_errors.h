#pragma once

#include "figure/csv_table.h"
#include "figure/figure.h"

namespace caustic {

/// Rows of speed_accuracy.csv: light that fog scatters once around a lamp, by ray marching, by photons gathered along
/// rays, by equi-angular sampling and by path tracing with free flights, against its closed form.
void addVolumeErrors(CsvTable& table, FigureContext& context);

}  // namespace caustic
