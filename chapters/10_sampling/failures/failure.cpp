#include "failures/failure_kinds.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    drawFailureBars(countFailures(samplingFailures(), FailureTrials::of(context, 1000)), context);
}

}  // namespace caustic
