#pragma once

#include "editor/editor.h"
#include "image/drawing.h"

namespace caustic {

/// Draws the panel on the right: the file, numbers of the curve, of the place at t and of what is selected, and help.
void paintPanel(Drawing& drawing, const Editor& editor);

}  // namespace caustic
