#pragma once

#include <cstdint>
#include <string>

#include "figure/figure.h"

namespace caustic {

/// What --render was told.
struct RenderWishes {
    std::int64_t passes = 0;     ///< in all; 0 for as many as there is time for
    double seconds = 0;          ///< in all; 0 for as long as the passes take
    std::string rule = "pass";   ///< or "point"
    double alpha = 2.0 / 3;      ///< of the rule
    double radius = 0;           ///< of the first pass, m; 0 for the scene's own
    std::int64_t photons = 1 << 16;  ///< a pass
    std::string checkpoint;      ///< file to go on from, when it is there, and to write to; empty for none
    std::int64_t every = 10;     ///< passes between two checkpoints
};

/// Renders one of namedScenes() pass by pass to `<out>/09_sppm/render_SCENE.png`, until the passes or the seconds are
/// over. With a checkpoint file it goes on where that stands, and writes it anew on the way and at the end.
/// @throws InputError for a wish that can't be granted: no such scene, a number out of its range, a checkpoint of
///         another picture or version, or a damaged one
void renderScene(const std::string& scene, const RenderWishes& wishes, const ChapterInputs& chapter,
                 const ChapterOptions& options);

}  // namespace caustic
