#include "failures/failure_kinds.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    drawFailureBars(countFailures(samplingFailures(), FailureTrials::of(context, context.byQuality(1000, 2000))), context);
}

}  // namespace caustic
