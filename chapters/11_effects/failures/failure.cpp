#include "failures/volume_failures.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    drawFailureMarks(countFailures(volumeKinds(), FailureTrials::of(context, context.byQuality(100, 1000))), context);
}

}  // namespace caustic
