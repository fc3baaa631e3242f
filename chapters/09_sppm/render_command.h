#pragma once

#include <string>

#include "figure/figure.h"
#include "scene_rendering.h"

namespace caustic {

/// Renders one of namedScenes() pass by pass to `<out>/09_sppm/render_SCENE.png`, until the passes or the seconds are
/// over. With a checkpoint file it goes on where that stands, and writes it anew on the way and at the end.
/// @throws InputError for a wish that can't be granted: no such scene, a number out of its range, a checkpoint of
///         another picture or version, or a damaged one
void renderScene(const std::string& scene, const RenderWishes& wishes, const ChapterInputs& chapter,
                 const ChapterOptions& options);

}  // namespace caustic
