#pragma once

#include <algorithm>
#include <filesystem>

#include "curve/profile_text.h"
#include "editor/editor.h"
#include "editor/editor_model.h"
#include "support/temporary_folder.h"

namespace caustic::test {

/// Two smooth segments and a corner.
inline BezierSpline waveSpline() {
    return BezierSpline::fromControlPoints({{0, 0, 0},
                                            {1, 2, 0},
                                            {2, 2, 0},
                                            {3, 0, 0},
                                            {4, -2, 0},
                                            {5, -1, 0},
                                            {6, 0, 0},
                                            {6, 1, 0},
                                            {8, 1, 0},
                                            {9, 0, 0}});
}

/// A closed one: smooth everywhere.
inline BezierSpline ringSpline() {
    return BezierSpline::fromControlPoints(
        {{1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 0, 0}}, true);
}

/// What the editor makes of it.
inline EditorModel modelOf(const BezierSpline& spline) { return EditorModel(spline, "test"); }

/// The largest distance from places of one curve to the other one.
inline Real distance(const BezierSpline& from, const EditorModel& to) {
    Real largest = 0;
    for (int i = 0; i <= 200; ++i) {
        const Vec3 point = from.position(Real(i) / 200 * Real(from.segments().size()));
        largest = std::max(largest, to.nearestPlace(point.head<2>())->distance);
    }
    return largest;
}

/// A file that holds the curve.
inline std::filesystem::path saved(const test::TemporaryFolder& folder, const BezierSpline& spline) {
    saveProfileText(spline, folder / "wave.txt");
    return folder / "wave.txt";
}

/// Where a point is drawn.
inline Vec2 pixelOf(const Editor& editor, const PointId& id) {
    return editor.view().toPixel(editor.model().position(id));
}

/// Presses and lets go.
inline void click(Editor& editor, const Vec2& pixel) {
    editor.mouse(MouseAction::LeftDown, pixel, false);
    editor.mouse(MouseAction::LeftUp, pixel, false);
}

/// Presses, moves in two steps, lets go.
/// @param alone  whether the partner of a handle stays
inline void drag(Editor& editor, const Vec2& from, const Vec2& to, bool alone = false) {
    editor.mouse(MouseAction::LeftDown, from, alone);
    editor.mouse(MouseAction::Move, (from + to) / 2, alone);
    editor.mouse(MouseAction::Move, to, alone);
    editor.mouse(MouseAction::LeftUp, to, alone);
}

}  // namespace caustic::test
