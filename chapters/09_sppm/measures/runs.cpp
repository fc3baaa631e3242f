#include "measures/runs.h"

namespace caustic {

const std::vector<ErrorPoint>& ChapterRuns::mirrorErrors(FigureContext& context) {
    if (!errors_) errors_ = mirrorCausticErrors(context.byQuality(0.5, 4.0), context);
    return *errors_;
}

const std::vector<BiasCurve>& ChapterRuns::bias(FigureContext& context) {
    if (!bias_) bias_ = biasCurves(context);
    return *bias_;
}

const std::vector<PassState>& ChapterRuns::passStates(FigureContext& context) {
    if (!states_) states_ = caustic::passStates(context);
    return *states_;
}

}  // namespace caustic
