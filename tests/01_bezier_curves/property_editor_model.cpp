#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/random.h"
#include "curve/profile_text.h"
#include "editor/editor.h"
#include "editor/editor_layout.h"
#include "editor/editor_model.h"
#include "editor_curves.h"

namespace caustic {
namespace {

using namespace test;

// Sine of the angle between the handles of a node: zero when they lie on one line.
Real bend(const EditorNode& node) {
    const Vec2 a = (node.anchor - node.in).normalized();
    const Vec2 b = (node.out - node.anchor).normalized();
    return a.x() * b.y() - a.y() * b.x();
}

TEST(EditorModel, HoldsTheSplineThatItWasGiven) {
    for (const BezierSpline& spline : {waveSpline(), ringSpline()}) {
        const EditorModel model = modelOf(spline);
        EXPECT_EQ(profileText(*model.spline()), profileText(spline)) << "Is every control point where it was?";
        EXPECT_EQ(model.segmentCount(), spline.segments().size());
        EXPECT_FALSE(model.changed());
    }
    EXPECT_EQ(modelOf(waveSpline()).points().size(), 10U);
    EXPECT_EQ(modelOf(ringSpline()).points().size(), 6U)
        << "A closed curve's end is its beginning: one point, not two.";
}

TEST(EditorModel, KnowsWhichJointsAreSmooth) {
    const auto nodes = modelOf(waveSpline()).nodes();
    EXPECT_TRUE(nodes[1].smooth);
    EXPECT_FALSE(nodes[2].smooth);
    const auto round = modelOf(ringSpline()).nodes();
    EXPECT_TRUE(round[0].smooth) << "The joint between the end and the beginning counts, too.";
    EXPECT_TRUE(round[1].smooth);
}

TEST(EditorModel, AnAnchorTakesItsHandlesAlong) {
    EditorModel model = modelOf(waveSpline());
    const EditorNode before = model.nodes()[1];
    model.beginDrag({1, PointKind::Anchor});
    model.dragTo({10, 10}, false);
    model.dragTo({3.5, 1}, false);
    model.endDrag();
    const Vec2 shift(0.5, 1);
    EXPECT_LT((model.nodes()[1].anchor - Vec2(3.5, 1)).norm(), 1e-12);
    EXPECT_LT((model.nodes()[1].in - before.in - shift).norm(), 1e-12);
    EXPECT_LT((model.nodes()[1].out - before.out - shift).norm(), 1e-12);
}

TEST(EditorModel, AHandleOfASmoothNodeTurnsItsPartner) {
    EditorModel model = modelOf(waveSpline());
    const Real length = (model.nodes()[1].out - model.nodes()[1].anchor).norm();
    Random random(61, {0});
    for (int i = 0; i < 100; ++i) {
        model.beginDrag({1, PointKind::In});
        model.dragTo({random.uniform(-5, 5), random.uniform(-5, 5)}, false);
        model.endDrag();
        EXPECT_NEAR(bend(model.nodes()[1]), 0, 1e-12) << "Do the handles stay on one line?";
        EXPECT_NEAR((model.nodes()[1].out - model.nodes()[1].anchor).norm(), length, 1e-10)
            << "Does the partner keep its length?";
        EXPECT_GE(model.spline()->joints()[0].continuity, Continuity::G1);
    }
}

TEST(EditorModel, AHandleOnItsOwnMakesACorner) {
    EditorModel model = modelOf(waveSpline());
    const Vec2 partner = model.nodes()[1].out;
    model.beginDrag({1, PointKind::In});
    model.dragTo({0, 5}, true);
    model.endDrag();
    EXPECT_EQ(model.nodes()[1].out, partner);
    EXPECT_FALSE(model.nodes()[1].smooth);
    // A corner's handles move apart without being asked to.
    model.beginDrag({1, PointKind::In});
    model.dragTo({1, 4}, false);
    model.endDrag();
    EXPECT_EQ(model.nodes()[1].out, partner);
}

// De Casteljau: both parts together are the curve.
TEST(EditorModel, ASplitKeepsTheShape) {
    Random random(62, {0});
    for (const BezierSpline& spline : {waveSpline(), ringSpline()}) {
        for (int i = 0; i < 50; ++i) {
            EditorModel model = modelOf(spline);
            const Vec2 near(random.uniform(-2, 10), random.uniform(-3, 3));
            const CurvePlace place = *model.nearestPlace(near);
            const PointId id = model.split(place);
            EXPECT_EQ(model.segmentCount(), spline.segments().size() + 1);
            EXPECT_LT((model.position(id) - place.point).norm(), 1e-12);
            EXPECT_LT(distance(spline, model), 1e-8);
            EXPECT_TRUE(model.nodes()[id.node].smooth);
        }
    }
}

TEST(EditorModel, FindsTheNearestPlace) {
    const EditorModel model = modelOf(waveSpline());
    const BezierSpline spline = waveSpline();
    Random random(63, {0});
    for (int i = 0; i < 200; ++i) {
        const Vec2 near(random.uniform(-2, 10), random.uniform(-3, 3));
        const CurvePlace place = *model.nearestPlace(near);
        Real smallest = 1e9;
        for (int k = 0; k <= 3000; ++k) {
            const Vec3 point = spline.position(k / Real(1000));
            smallest = std::min(smallest, (point.head<2>() - near).norm());
        }
        EXPECT_LE(place.distance, smallest + 1e-6);
        EXPECT_LT((model.segment(place.segment).position(place.t).head<2>() - place.point).norm(), 1e-12);
    }
    EXPECT_FALSE(EditorModel().nearestPlace({0, 0}).has_value());
}

TEST(EditorModel, AddedPointsGoOnSmoothly) {
    EditorModel model;
    EXPECT_FALSE(model.spline().has_value());
    const Vec2 places[] = {{0, 0}, {1, 2}, {3, 1}, {5, 5}};
    for (const Vec2& place : places) {
        const PointId id = model.add(place);
        EXPECT_EQ(model.position(id), place);
    }
    EXPECT_EQ(model.segmentCount(), 3U);
    for (const Joint& joint : model.spline()->joints()) EXPECT_GE(joint.continuity, Continuity::G1);
    // Nearer to the beginning, it comes before it.
    EXPECT_EQ(model.add({-1, -1}), (PointId{0, PointKind::Anchor}));
    EXPECT_EQ(model.segmentCount(), 4U);
    EXPECT_GE(model.spline()->joints()[0].continuity, Continuity::G1);
}

TEST(EditorModel, APointAddedToAClosedCurveLiesOnIt) {
    EditorModel model = modelOf(ringSpline());
    const PointId id = model.add({0, 3});
    EXPECT_EQ(model.position(id), Vec2(0, 3));
    EXPECT_EQ(model.segmentCount(), 3U);
    EXPECT_TRUE(model.closed());
    model.undo();
    EXPECT_EQ(profileText(*model.spline()), profileText(ringSpline())) << "Is it one step of undo?";
}

TEST(EditorModel, DeletingAPointLeavesItsNeighbours) {
    EditorModel model = modelOf(waveSpline());
    const auto before = model.nodes();
    model.remove({1, PointKind::Anchor});
    ASSERT_EQ(model.segmentCount(), 2U);
    EXPECT_EQ(model.nodes()[0].out, before[0].out);
    EXPECT_EQ(model.nodes()[1].in, before[2].in);
    for (int i = 0; i < 3; ++i) model.remove({0, PointKind::Anchor});
    EXPECT_TRUE(model.nodes().empty());
    EXPECT_FALSE(model.spline().has_value());
    model.remove({0, PointKind::Anchor});
    for (int i = 0; i < 4; ++i) model.undo();
    EXPECT_FALSE(model.changed());
}

TEST(EditorModel, DeletingAHandleDrawsItBack) {
    EditorModel model = modelOf(waveSpline());
    model.remove({1, PointKind::Out});
    EXPECT_EQ(model.nodes()[1].out, model.nodes()[1].anchor);
    EXPECT_EQ(model.segmentCount(), 3U);
    model.toggleSmooth(1);
    EXPECT_GT((model.nodes()[1].out - model.nodes()[1].anchor).norm(), 0.1) << "Can it be got back?";
    EXPECT_NEAR(bend(model.nodes()[1]), 0, 1e-12);
}

TEST(EditorModel, SmoothingACornerLinesItsHandlesUp) {
    EditorModel model = modelOf(waveSpline());
    ASSERT_GT(std::abs(bend(model.nodes()[2])), 0.1);
    model.toggleSmooth(2);
    EXPECT_NEAR(bend(model.nodes()[2]), 0, 1e-12);
    EXPECT_GE(model.spline()->joints()[1].continuity, Continuity::G1);
    model.toggleSmooth(2);
    EXPECT_FALSE(model.nodes()[2].smooth);
}

TEST(EditorModel, ClosesAndOpens) {
    EditorModel model = modelOf(waveSpline());
    model.toggleClosed();
    EXPECT_TRUE(model.closed());
    EXPECT_EQ(model.segmentCount(), 4U);
    EXPECT_LT((model.spline()->position(4) - model.spline()->position(0)).norm(), 1e-12);
    model.toggleClosed();
    EXPECT_EQ(profileText(*model.spline()), profileText(waveSpline()));
    EditorModel point;
    point.add({1, 1});
    point.toggleClosed();
    EXPECT_FALSE(point.closed()) << "One point makes no loop.";
}

// Whatever is done, undoing it all gives the beginning, and doing it again the end.
TEST(EditorModel, UndoTakesEverythingBack) {
    Random random(64, {0});
    for (int trial = 0; trial < 50; ++trial) {
        EditorModel model = modelOf(trial % 2 == 0 ? waveSpline() : ringSpline());
        const std::string beginning = profileText(*model.spline());
        int steps = 0;
        for (int i = 0; i < 30; ++i) {
            const Vec2 place(random.uniform(-5, 10), random.uniform(-5, 5));
            const auto points = model.points();
            const PointId any = points.empty() ? PointId{} : points[random.below(points.size())];
            switch (random.below(6)) {
                case 0:
                    model.add(place);
                    break;
                case 1:
                    if (!model.nearestPlace(place)) continue;
                    model.split(*model.nearestPlace(place));
                    break;
                case 2:
                    if (model.nodes().size() < 3) continue;
                    model.remove(any);
                    break;
                case 3:
                    if (points.empty()) continue;
                    model.beginDrag(any);
                    model.dragTo(place, random.below(2) == 0);
                    model.dragTo(2 * place, random.below(2) == 0);
                    model.endDrag();
                    break;
                case 4:
                    if (points.empty()) continue;
                    model.toggleSmooth(any.node);
                    break;
                default:
                    if (model.nodes().size() < 2) continue;
                    model.toggleClosed();
                    break;
            }
            ++steps;
        }
        const std::string end = profileText(*model.spline());
        for (int i = 0; i < steps; ++i) ASSERT_TRUE(model.undo().has_value());
        EXPECT_FALSE(model.undo().has_value());
        EXPECT_EQ(profileText(*model.spline()), beginning);
        EXPECT_FALSE(model.changed());
        for (int i = 0; i < steps; ++i) ASSERT_TRUE(model.redo().has_value());
        EXPECT_FALSE(model.redo().has_value());
        EXPECT_EQ(profileText(*model.spline()), end);
    }
}

TEST(EditorModel, AChangeEndsWhatCouldBeDoneAgain) {
    EditorModel model = modelOf(waveSpline());
    model.add({20, 0});
    model.undo();
    model.add({0, 20});
    EXPECT_FALSE(model.redo().has_value());
}

TEST(EditorModel, ADragThatGoesNowhereIsNoStep) {
    EditorModel model = modelOf(waveSpline());
    model.beginDrag({1, PointKind::Anchor});
    model.dragTo({3, 0}, false);
    model.endDrag();
    EXPECT_FALSE(model.undo().has_value());
}

TEST(EditorModel, HistoryIsBounded) {
    EditorModel model;
    for (std::size_t i = 0; i < EditorModel::mostSteps + 20; ++i) {
        model.add({Real(i % 2), Real(i)});
        model.remove({0, PointKind::Anchor});
    }
    std::size_t steps = 0;
    while (model.undo()) ++steps;
    EXPECT_EQ(steps, EditorModel::mostSteps);
}

TEST(EditorModel, RefusesWhatIsNotFlatOrNotOneCurve) {
    EXPECT_THROW(modelOf(BezierSpline::fromControlPoints({{0, 0, 0}, {1, 0, 1}, {2, 0, 0}, {3, 0, 0}})), InputError);
    const BezierCurve line({{0, 0, 0}, {1, 1, 0}});
    const BezierCurve away({{5, 5, 0}, {6, 6, 0}});
    EXPECT_THROW(modelOf(BezierSpline({line, away})), InputError);
    EXPECT_THROW(modelOf(BezierSpline({line}, true)), InputError) << "Closed, but its end is not its beginning.";
    const std::vector<BezierCurve> many(EditorModel::mostSegments + 1, BezierCurve({Vec3(0, 0, 0)}));
    EXPECT_THROW(modelOf(BezierSpline(many)), InputError);
}

}  // namespace
}  // namespace caustic
