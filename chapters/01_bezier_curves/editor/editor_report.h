#pragma once

#include <string>

#include "editor/editor.h"

namespace caustic {

/// What the window shows, as JSON: file, whether changed, status line, t, and each control point with its place in the
/// world and in the window. For tests, and for scripts that watch the editor.
std::string editorReport(const Editor& editor);

}  // namespace caustic
