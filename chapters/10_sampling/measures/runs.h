#pragma once

#include <optional>
#include <vector>

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

private:
    std::optional<std::vector<SamplerPoint>> samplers_;
};

}  // namespace caustic
