#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "camera/box_filter.h"
#include "figure/chapter_option.h"
#include "figure/figure.h"
#include "integrator/sppm.h"
#include "sampling/sobol_sampler.h"
#include "scenes.h"

namespace caustic {

/// What --render was told.
struct RenderWishes {
    std::int64_t passes = 0;         ///< in all; 0 for as many as there is time for
    double seconds = 0;              ///< in all; 0 for as long as the passes take
    std::string rule = "pass";       ///< or "point"
    double alpha = 2.0 / 3;          ///< of the rule
    double radius = 0;               ///< of the first pass, m; 0 for the scene's own
    std::int64_t photons = 1 << 16;  ///< a pass
    std::string checkpoint;          ///< file to go on from, when it is there, and to write to; empty for none
    std::int64_t every = 10;         ///< passes between two checkpoints
};

/// The options by which both programs that render a scene, alone or over MPI ranks, are told what they want: all but
/// --passes, --time and --rule.
std::vector<ChapterOption> renderOptions(RenderWishes& wishes);

/// One of namedScenes() on its way to `<out>/09_sppm/render_SCENE.png`: all that the way has in common, whoever runs
/// the passes.
class SceneRendering {
public:
    /// @throws InputError for a wish that can't be granted: no such scene, a number out of its range
    SceneRendering(const std::string& scene, const RenderWishes& wishes, const ChapterInputs& chapter,
                   const ChapterOptions& options);
    SceneRendering(const SceneRendering&) = delete;
    SceneRendering& operator=(const SceneRendering&) = delete;

    /// What runs the passes.
    Sppm& sppm() { return sppm_; }

    /// Names the picture for checkpoints: everything that makes it another one.
    const std::string& picture() const { return picture_; }

    /// Where it goes.
    const std::filesystem::path& file() const { return file_; }

    /// The paths of a pass. By rule Pass the first call looks for the edges of lamps, unless they are known.
    std::vector<PathId> pathsOf(std::int64_t pass);

    /// For those who share that search: edgesOfRows, and what comes of it once all rows have been looked at.
    std::vector<std::uint8_t> edgesOf(int firstRow, int step) const;
    void useEdges(const std::vector<std::uint8_t>& ofAllRows);

    /// Nothing yet.
    Rendering empty() const;

    /// What the checkpoint holds when there is one, else nothing yet.
    /// @throws InputError for a checkpoint of another picture or version, or a damaged one
    Rendering begun();

    /// Writes the checkpoint, when one is wished.
    /// @return whether one is
    bool saveState(const Rendering& soFar) const;

    /// Writes the picture.
    void savePicture(const Rendering& soFar) const;

    /// Writes both for the last time, and says so on standard output.
    /// @throws std::runtime_error when a sample was no finite number
    void finish(const Rendering& all) const;

private:
    const NamedScene& named_;
    std::string checkpoint_;
    int threads_;
    Scene scene_;
    SobolSampler sampler_;
    BoxFilter filter_;
    Sppm sppm_;
    std::string picture_;
    std::filesystem::path file_;
    std::optional<std::vector<Pixel>> edges_;  // by rule Pass, once they are needed
};

}  // namespace caustic
