#include "figure/csv_table.h"
#include "figures.h"
#include "measures/map_errors.h"
#include "measures/volume_errors.h"

namespace caustic {

void chartSpeedAccuracy(FigureContext& context) {
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    addVolumeErrors(table, context);
    addMapErrors(table, context);
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
