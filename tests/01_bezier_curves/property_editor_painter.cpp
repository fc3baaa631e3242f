#include <gtest/gtest.h>

#include "curve/profile_text.h"
#include "editor/editor.h"
#include "editor/editor_layout.h"
#include "editor/editor_model.h"
#include "editor/editor_painter.h"
#include "editor/editor_report.h"
#include "editor_curves.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

using namespace test;

TEST(EditorPainter, PaintsPointsWhereTheReportSaysThatTheyAre) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, waveSpline()).string());
    EditorPainter painter;
    const auto bgr = painter.paint(editor).bgr();
    const auto colour = [&](const Vec2& at) {
        const auto i =
            static_cast<std::size_t>(3 * (static_cast<int>(at.y()) * editor_layout::width + static_cast<int>(at.x())));
        return Ink{bgr[i + 2], bgr[i + 1], bgr[i]};
    };
    for (const PointId& id : editor.model().points()) {
        const Vec2 at = pixelOf(editor, id);
        EXPECT_EQ(colour(at), palette::white) << "A point that isn't selected is white within its ring.";
        const Ink ring = colour(at + Vec2(id.kind == PointKind::Anchor ? 5.3 : 4.3, 0));
        EXPECT_EQ(ring.blue > ring.red, id.kind == PointKind::Anchor) << "Anchors are blue, handles are vermilion.";
    }
    EXPECT_NE(editorReport(editor).find("\"segments\": 3"), std::string::npos);
}

TEST(EditorPainter, EveryStateCanBePainted) {
    const test::TemporaryFolder folder;
    saveProfileText(ringSpline(), folder / "ring.txt");
    Editor editor((folder / "ring.txt").string());
    EditorPainter painter;
    std::vector<std::uint8_t> last;
    for (const char key : std::string("mbcao")) {
        editor.key(key);
        const auto now = painter.paint(editor).bgr();
        EXPECT_NE(now, last) << key << " is to be seen.";
        last = now;
    }
}

}  // namespace
}  // namespace caustic
