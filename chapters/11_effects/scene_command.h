#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Renders a scene of one's own to `<out>/11_effects/NAME.png`, NAME as the file's without its ending.
/// @throws InputError as loadScene does, and when nothing in the scene shines
void renderOwnScene(const std::string& file, const ChapterInputs& chapter, const ChapterOptions& options);

}  // namespace caustic
