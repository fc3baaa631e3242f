#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/error.h"
#include "core/random.h"
#include "curve/profile_file.h"
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

std::filesystem::path saved(const test::TemporaryFolder& folder, const BezierSpline& spline) {
    saveProfileText(spline, folder / "wave.txt");
    return folder / "wave.txt";
}

Vec2 pixelOf(const Editor& editor, const PointId& id) { return editor.view().toPixel(editor.model().position(id)); }

void click(Editor& editor, const Vec2& pixel) {
    editor.mouse(MouseAction::LeftDown, pixel, false);
    editor.mouse(MouseAction::LeftUp, pixel, false);
}

void drag(Editor& editor, const Vec2& from, const Vec2& to, bool alone = false) {
    editor.mouse(MouseAction::LeftDown, from, alone);
    editor.mouse(MouseAction::Move, (from + to) / 2, alone);
    editor.mouse(MouseAction::Move, to, alone);
    editor.mouse(MouseAction::LeftUp, to, alone);
}

TEST(Editor, DragsThePointUnderTheMouse) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    const PointId id{1, PointKind::Anchor};
    const Vec2 from = pixelOf(editor, id);
    drag(editor, from + Vec2(2, -1), from + Vec2(42, -31));
    EXPECT_LT((pixelOf(editor, id) - (from + Vec2(40, -30))).norm(), 1e-9) << "Does it jump to the mouse's tip?";
    EXPECT_EQ(editor.selected(), id);
    EXPECT_TRUE(editor.model().changed());
}

TEST(Editor, AnAnchorGoesBeforeTheHandleThatLiesOnIt) {
    const test::TemporaryFolder folder;
    Editor editor(
        saved(folder, BezierSpline::fromControlPoints({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}})).string());
    click(editor, pixelOf(editor, {0, PointKind::Anchor}) + Vec2(1, 1));
    EXPECT_EQ(editor.selected(), (PointId{0, PointKind::Anchor}));
}

TEST(Editor, ADoubleClickSplitsTheCurveOrGoesOn) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    const Vec2 onCurve = editor.view().toPixel(editor.model().spline()->position(0.4).head<2>());
    editor.mouse(MouseAction::LeftDouble, onCurve + Vec2(1, 2), false);
    EXPECT_EQ(editor.model().segmentCount(), 4U);
    EXPECT_LT(distance(wave(), editor.model()), 1e-8) << "Does the curve keep its shape?";
    editor.mouse(MouseAction::LeftDouble, {860, 100}, false);
    EXPECT_EQ(editor.model().segmentCount(), 5U);
    EXPECT_LT((pixelOf(editor, *editor.selected()) - Vec2(860, 100)).norm(), 1e-9);
    editor.mouse(MouseAction::LeftDouble, {860, 100}, false);
    EXPECT_EQ(editor.model().segmentCount(), 5U) << "A double click on a point adds nothing.";
    editor.mouse(MouseAction::LeftDouble, {1000, 100}, false);
    EXPECT_EQ(editor.model().segmentCount(), 5U) << "Nor does one on the panel.";
}

TEST(Editor, TheAddKeyWaitsForOneClick) {
    Editor editor("");
    for (const Vec2& place : {Vec2(100, 500), Vec2(300, 200), Vec2(600, 400)}) {
        editor.key('a');
        EXPECT_TRUE(editor.adding());
        click(editor, place);
        EXPECT_FALSE(editor.adding());
    }
    EXPECT_EQ(editor.model().segmentCount(), 2U);
    editor.key('a');
    click(editor, {300, 200});
    EXPECT_TRUE(editor.complaining()) << "There is a point already.";
    EXPECT_EQ(editor.model().segmentCount(), 2U);
    editor.key('a');
    editor.key(editor_key::escape);
    EXPECT_FALSE(editor.adding());
}

TEST(Editor, DeletesWhatIsSelected) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    for (const int key : {int('d'), editor_key::backspace, editor_key::remove}) {
        click(editor, pixelOf(editor, {1, PointKind::Anchor}));
        editor.key(key);
    }
    EXPECT_EQ(editor.model().nodes().size(), 1U);
    EXPECT_FALSE(editor.selected().has_value());
    editor.key('d');
    EXPECT_TRUE(editor.complaining());
    for (int i = 0; i < 3; ++i) editor.key('z');
    EXPECT_FALSE(editor.model().changed());
    editor.key('y');
    EXPECT_EQ(editor.model().segmentCount(), 2U);
}

TEST(Editor, TheSliderAndKeysChooseT) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    click(editor, editor_layout::sliderStart());
    EXPECT_EQ(editor.u(), 0);
    drag(editor, editor_layout::sliderStart(), editor_layout::sliderEnd());
    EXPECT_EQ(editor.u(), 3);
    EXPECT_EQ(editor.place()->segment, 2U);
    EXPECT_EQ(editor.place()->t, 1);
    for (int i = 0; i < 25; ++i) editor.key(',');
    EXPECT_NEAR(editor.u(), 2.75, 1e-12);
    editor.key('.');
    EXPECT_NEAR(editor.u(), 2.76, 1e-12);
    editor.key('[');
    EXPECT_EQ(editor.u(), 2);
    editor.key('[');
    EXPECT_EQ(editor.u(), 1);
    editor.key(']');
    EXPECT_EQ(editor.u(), 2);
    for (int i = 0; i < 9; ++i) editor.key(']');
    EXPECT_EQ(editor.u(), 3);
    EXPECT_FALSE(editor.model().changed());
}

TEST(Editor, AClickOnTheCurveChoosesT) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    click(editor, editor.view().toPixel(editor.model().spline()->position(2.3).head<2>()));
    EXPECT_NEAR(editor.u(), 2.3, 1e-6);
    click(editor, {20, 20});
    EXPECT_NEAR(editor.u(), 2.3, 1e-6);
}

TEST(Editor, ZoomKeepsThePixelAndPanMovesIt) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    const Vec2 pixel(300, 200);
    const Vec2 world = editor.view().toWorld(pixel);
    editor.zoom(3, pixel);
    EXPECT_LT((editor.view().toPixel(world) - pixel).norm(), 1e-9);
    editor.mouse(MouseAction::PanDown, pixel, false);
    editor.mouse(MouseAction::Move, {350, 260}, false);
    editor.mouse(MouseAction::PanUp, {350, 260}, false);
    editor.mouse(MouseAction::Move, {800, 100}, false);
    EXPECT_LT((editor.view().toPixel(world) - Vec2(350, 260)).norm(), 1e-9);
    for (int i = 0; i < 2000; ++i) editor.key('-');
    for (int i = 0; i < 4000; ++i) editor.key('+');
    EXPECT_TRUE(std::isfinite(editor.view().scale()));
    editor.key('f');
    const Vec2 start = pixelOf(editor, {0, PointKind::Anchor});
    EXPECT_TRUE(editor_layout::sheet().contains(start)) << "Does f bring everything back?";
}

TEST(Editor, SavesWhatItShows) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    drag(editor, pixelOf(editor, {0, PointKind::Out}), Vec2(200, 50));
    editor.key('s');
    EXPECT_FALSE(editor.model().changed()) << editor.status();
    EXPECT_EQ(profileText(loadProfile((folder / "wave.txt").string())), profileText(*editor.model().spline()));
}

TEST(Editor, AnSvgIsSavedAsTextBesideIt) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg" height="10"><path d="M0 0C1 2 3 4 5 6"/></svg>)";
    Editor editor((folder / "a.svg").string());
    editor.key('s');
    EXPECT_EQ(profileText(loadProfile((folder / "a.txt").string())), profileText(*editor.model().spline()));
}

TEST(Editor, AsksBeforeItReplacesAFileThatItDidNotOpen) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "precious";
    std::ofstream(folder / "a.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg" height="10"><path d="M0 0C1 2 3 4 5 6"/></svg>)";
    Editor editor((folder / "a.svg").string());
    const auto contents = [&] {
        std::ifstream file(folder / "a.txt");
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    editor.key('s');
    EXPECT_TRUE(editor.complaining());
    EXPECT_EQ(contents(), "precious");
    editor.key('b');
    editor.key('s');
    EXPECT_EQ(contents(), "precious") << "Does another key in between take the question back?";
    editor.key('s');
    EXPECT_NE(contents(), "precious");
    EXPECT_FALSE(editor.complaining()) << editor.status();
}

TEST(Editor, AsksBeforeChangesAreLost) {
    const test::TemporaryFolder folder;
    const auto changed = [&] {
        Editor editor(saved(folder, wave()).string());
        drag(editor, pixelOf(editor, {1, PointKind::Anchor}), {300, 300});
        return editor;
    };
    Editor quitting = changed();
    quitting.key('q');
    EXPECT_FALSE(quitting.finished());
    quitting.key('q');
    EXPECT_TRUE(quitting.finished());

    Editor working = changed();
    working.key('q');
    drag(working, pixelOf(working, {1, PointKind::Anchor}), {350, 300});
    working.key('q');
    EXPECT_FALSE(working.finished()) << "A question from long ago is not answered now.";

    Editor closing = changed();
    closing.closeRequested();
    EXPECT_FALSE(closing.finished());
    closing.closeRequested();
    EXPECT_TRUE(closing.finished());

    Editor saving = changed();
    saving.key('q');
    saving.key('s');
    saving.key('q');
    EXPECT_TRUE(saving.finished());

    Editor opening = changed();
    opening.key('o');
    EXPECT_TRUE(opening.choices().empty());
    opening.key('o');
    EXPECT_FALSE(opening.choices().empty());

    Editor untouched(saved(folder, wave()).string());
    untouched.key('q');
    EXPECT_TRUE(untouched.finished());
}

TEST(Editor, OpensAnotherProfileFromTheList) {
    const test::TemporaryFolder folder;
    saveProfileText(ring(), folder / "ring.txt");
    std::ofstream(folder / "broken.txt") << "1 2 three";
    std::ofstream(folder / "other.dat") << "no profile";
    Editor editor(saved(folder, wave()).string());
    editor.key('o');
    ASSERT_EQ(editor.choices().size(), 3U) << "broken.txt, ring.txt, wave.txt";
    editor.key('1');
    EXPECT_TRUE(editor.complaining()) << "A broken file is said, not thrown.";
    EXPECT_EQ(profileText(*editor.model().spline()), profileText(wave())) << "And what was there stays.";
    editor.key('o');
    click(editor, editor_layout::chooserRow(1).center());
    EXPECT_EQ(profileText(*editor.model().spline()), profileText(ring()));
    EXPECT_EQ(editor.file().filename(), "ring.txt");
    editor.key('o');
    editor.key(editor_key::escape);
    EXPECT_TRUE(editor.choices().empty());
    EXPECT_FALSE(editor.finished());
}

TEST(Editor, BeginsANewFile) {
    const test::TemporaryFolder folder;
    Editor editor((folder / "new.txt").string());
    EXPECT_EQ(editor.model().nodes().size(), 0U);
    editor.key('s');
    EXPECT_TRUE(editor.complaining()) << "There is nothing to save yet.";
    editor.mouse(MouseAction::LeftDouble, {100, 100}, false);
    editor.mouse(MouseAction::LeftDouble, {400, 300}, false);
    editor.key('s');
    EXPECT_EQ(loadProfile((folder / "new.txt").string()).segments().size(), 1U);
}

TEST(Editor, RefusesWhatCannotBeOpened) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(Editor((folder / "none.svg").string()), InputError);
    EXPECT_THROW(Editor((folder / "none" / "a.txt").string()), InputError);
    EXPECT_THROW(Editor(folder.path().string()), InputError);
    std::ofstream(folder / "bad.txt") << "0 0\n1 nan\n";
    EXPECT_THROW(Editor((folder / "bad.txt").string()), InputError);
}

TEST(Editor, SaysWhatCannotBeSaved) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
    std::filesystem::remove(folder / "wave.txt");
    std::filesystem::create_directory(folder / "wave.txt");
    drag(editor, pixelOf(editor, {1, PointKind::Anchor}), {300, 300});
    editor.key('s');
    EXPECT_TRUE(editor.complaining());
    EXPECT_TRUE(editor.model().changed()) << "What isn't on the disk isn't saved.";
}

// Any events in any order: no crash, no non-finite number, and every picture can be painted.
TEST(Editor, SurvivesAnyEvents) {
    const test::TemporaryFolder folder;
    const std::string keys = "adgzyzy,.[]bcmf+-l";
    Random random(65, {0});
    for (int trial = 0; trial < 20; ++trial) {
        Editor editor(trial % 2 == 0 ? "" : saved(folder, wave()).string());
        EditorPainter painter;
        for (int i = 0; i < 300; ++i) {
            const Vec2 pixel(random.uniform(-50, 1300), random.uniform(-50, 800));
            if (random.below(3) == 0)
                editor.key(keys[random.below(keys.size())]);
            else
                editor.mouse(static_cast<MouseAction>(random.below(6)), pixel, random.below(2) == 0);
            for (const PointId& id : editor.model().points()) ASSERT_TRUE(editor.model().position(id).allFinite());
            ASSERT_TRUE(editor.u() >= 0 && editor.u() <= Real(editor.model().segmentCount()));
        }
        painter.paint(editor);
    }
}

// ---- The picture.

TEST(EditorPainter, PaintsPointsWhereTheReportSaysThatTheyAre) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, wave()).string());
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
    saveProfileText(ring(), folder / "ring.txt");
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
