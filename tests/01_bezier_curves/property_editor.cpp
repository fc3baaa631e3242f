#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/random.h"
#include "editor/editor.h"
#include "editor/editor_layout.h"
#include "editor/editor_model.h"
#include "editor/editor_painter.h"
#include "editor_curves.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

using namespace test;

TEST(Editor, DragsThePointUnderTheMouse) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, waveSpline()).string());
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
    Editor editor(saved(folder, waveSpline()).string());
    const Vec2 onCurve = editor.view().toPixel(editor.model().spline()->position(0.4).head<2>());
    editor.mouse(MouseAction::LeftDouble, onCurve + Vec2(1, 2), false);
    EXPECT_EQ(editor.model().segmentCount(), 4U);
    EXPECT_LT(distance(waveSpline(), editor.model()), 1e-8) << "Does the curve keep its shape?";
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
    Editor editor(saved(folder, waveSpline()).string());
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
    Editor editor(saved(folder, waveSpline()).string());
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
    Editor editor(saved(folder, waveSpline()).string());
    click(editor, editor.view().toPixel(editor.model().spline()->position(2.3).head<2>()));
    EXPECT_NEAR(editor.u(), 2.3, 1e-6);
    click(editor, {20, 20});
    EXPECT_NEAR(editor.u(), 2.3, 1e-6);
}

TEST(Editor, ZoomKeepsThePixelAndPanMovesIt) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, waveSpline()).string());
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

// Any events in any order: no crash, no non-finite number, and every picture can be painted.
TEST(Editor, SurvivesAnyEvents) {
    const test::TemporaryFolder folder;
    const std::string keys = "adgzyzy,.[]bcmf+-l";
    Random random(65, {0});
    for (int trial = 0; trial < 20; ++trial) {
        Editor editor(trial % 2 == 0 ? "" : saved(folder, waveSpline()).string());
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

}  // namespace
}  // namespace caustic
