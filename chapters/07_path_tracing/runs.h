#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/figure.h"
#include "integrator/render.h"
#include "methods.h"
#include "work.h"

namespace caustic {

/// How far off a method was after so much work.
struct ConvergencePoint {
    std::string scene;         ///< MeasuredScene::name
    Method method;             ///< which
    std::int64_t samples = 0;  ///< paths a pixel
    double seconds = 0;        ///< of one thread's computing time
    Real error = 0;            ///< RMSE against the scene's reference
};

/// What the figures of one run share.
class ChapterRuns {
public:
    /// @param sources  top of the repository, where the chapter's work counts are
    explicit ChapterRuns(std::filesystem::path sources) : sources_(std::move(sources)) {}

    /// Renders, and notes how many samples there were.
    /// @param samples  paths a pixel, at least 1
    Rendering render(const Integrator& integrator, std::int64_t samples, FigureContext& context);

    /// Enters a picture's samples.
    void note(std::int64_t samples, std::int64_t bad);

    /// Every method on every measured scene; made once and kept.
    const std::vector<ConvergencePoint>& convergence(FigureContext& context);

    /// Samples of all figures so far.
    std::int64_t samples() const { return samples_; }
    /// How many of them were no finite numbers.
    std::int64_t bad() const { return bad_; }

    /// How much work each method does in the same time.
    WorkCounts work() const { return WorkCounts(sources_); }

private:
    std::filesystem::path sources_;
    std::int64_t samples_ = 0;
    std::int64_t bad_ = 0;
    std::optional<std::vector<ConvergencePoint>> convergence_;
};

}  // namespace caustic
