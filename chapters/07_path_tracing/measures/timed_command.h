#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Renders a scene by each method for some seconds of one thread's computing time, holds the pictures against the
/// scene's reference after each doubling of samples, and writes pictures and `timed_SCENE.csv`.
/// @param seconds  of each method, greater than 0
/// @param scene    one of measuredScenes()
/// @throws InputError when there is no such scene
void renderTimed(double seconds, const std::string& scene, const ChapterInputs& chapter, const ChapterOptions& options);

}  // namespace caustic
