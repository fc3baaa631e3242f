#include "failures/map_failures.h"
#include "failures/volume_failures.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    std::vector<FailureRow> rows = countFailures(mapKinds(), FailureTrials::of(context, 2000));
    const std::vector<FailureRow> inMedia =
        countFailures(volumeKinds(), FailureTrials::of(context, context.byQuality(100, 1000)));
    rows.insert(rows.end(), inMedia.begin(), inMedia.end());
    drawFailureBars(rows, context);
}

}  // namespace caustic
