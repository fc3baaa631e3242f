#include "figure/quantities.h"
#include "figures.h"
#include "measures/map_quantities.h"
#include "measures/volume_quantities.h"

namespace caustic {

void tabulateQuantities(FigureContext& context) {
    writeQuantities({[&](CsvTable& table) { addMapQuantities(table, context); },
                     [&](CsvTable& table) { addVolumeQuantities(table, context); }},
                    context);
}

}  // namespace caustic
