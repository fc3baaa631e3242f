#pragma once

#include <optional>
#include <vector>

#include "measures/bias_points.h"
#include "measures/error_points.h"
#include "measures/pass_states.h"

namespace caustic {

/// What the figures of one run share.
class ChapterRuns {
public:
    /// Errors of all methods on the caustic in the mirror; made once and kept.
    const std::vector<ErrorPoint>& mirrorErrors(FigureContext& context);

    /// How bias falls; made once and kept.
    const std::vector<BiasCurve>& bias(FigureContext& context);

    /// Radius and memory over passes; made once and kept.
    const std::vector<PassState>& passStates(FigureContext& context);

private:
    std::optional<std::vector<ErrorPoint>> errors_;
    std::optional<std::vector<BiasCurve>> bias_;
    std::optional<std::vector<PassState>> states_;
};

}  // namespace caustic
