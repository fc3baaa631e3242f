#include "failures/failure_kinds.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    std::vector<FailureRow> rows = countFailures(structureKinds(), FailureTrials::of(context, 2000));
    const std::vector<FailureRow> rendered =
        countFailures(settingKinds(), FailureTrials::of(context, context.byQuality(50, 1000)));
    rows.insert(rows.end(), rendered.begin(), rendered.end());
    drawFailureBars(rows, context);
}

}  // namespace caustic
