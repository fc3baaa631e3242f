#pragma once

#include <optional>
#include <vector>

#include "measures/adaptive_points.h"
#include "measures/sampler_points.h"

namespace caustic {

/// What the figures of one run share.
class ChapterRuns {
public:
    /// Errors of all samplers; made once and kept.
    const std::vector<SamplerPoint>& samplers(FigureContext& context) {
        if (!samplers_) samplers_ = samplerPoints(context);
        return *samplers_;
    }

    /// Adaptive beside uniform sampling; made once and kept.
    const std::vector<AdaptivePoint>& adaptive(FigureContext& context) {
        if (!adaptive_) adaptive_ = adaptivePoints(context);
        return *adaptive_;
    }

private:
    std::optional<std::vector<AdaptivePoint>> adaptive_;
    std::optional<std::vector<SamplerPoint>> samplers_;
};

}  // namespace caustic
