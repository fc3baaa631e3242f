#pragma once

#include "editor/editor.h"
#include "image/drawing.h"

namespace caustic {

/// Draws what the editor's window shows.
class EditorPainter {
public:
    EditorPainter();

    /// The picture of the editor as it is now; valid until the next call.
    const Drawing& paint(const Editor& editor);

private:
    Drawing drawing_;
};

}  // namespace caustic
