#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/figure.h"

namespace caustic {

/// What --render is asked for.
struct RenderWishes {
    std::string sampler = "sobol";  ///< one of samplerNames()
    std::string rule = "interval";  ///< uniform, hash, edges, interval or gain
    std::int64_t paths = 64;        ///< of a pixel: on average, and of a uniform picture each
    double tolerance = 0.02;        ///< of the rule interval
    std::int64_t width = 200;       ///< pixels
    std::string checkpoint = {};    ///< a file: what is gone on from when it is there, and written; none when empty
};

/// What --rule may be.
const std::vector<std::string>& ruleNames();

/// Renders a study's scene with any sampler and rule; writes `<out>/10_sampling/render_SCENE.png`, and unless it is
/// uniform a map of its paths, `render_SCENE_paths.png`.
/// @throws InputError when a wish is out of its range, or the checkpoint is of another picture
void renderScene(const std::string& scene, const RenderWishes& wishes, const ChapterInputs& chapter,
                 const ChapterOptions& options);

}  // namespace caustic
