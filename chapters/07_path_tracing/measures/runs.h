#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

#include "figure/figure.h"
#include "measures/convergence_points.h"
#include "measures/work.h"

namespace caustic {

/// What the figures of one run share.
class ChapterRuns {
public:
    /// @param sources  top of the repository, where the chapter's work counts are
    explicit ChapterRuns(std::filesystem::path sources) : sources_(std::move(sources)) {}

    /// Every method on every measured scene, errors as root mean squares over some repetitions; made once and kept.
    const ConvergencePoints& convergence(FigureContext& context);

    /// How many samples that took.
    std::int64_t samples() const { return samples_; }
    /// How many of them were no finite numbers.
    std::int64_t bad() const { return bad_; }

    /// How much work each method does in the same time.
    WorkCounts work() const { return WorkCounts(sources_); }

private:
    std::filesystem::path sources_;
    std::int64_t samples_ = 0;
    std::int64_t bad_ = 0;
    std::optional<ConvergencePoints> convergence_;
};

}  // namespace caustic
