#include "editor/editor_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "curve/curve_bounds.h"
#include "editor/editor_layout.h"
#include "editor/editor_panel.h"
#include "editor/editor_style.h"

namespace caustic {

namespace {

using namespace editor_layout;
using namespace editor_style;

constexpr int samples = 2;  // per pixel and axis: a redraw must follow the mouse
// The next of 1, 2, 5, 10, 20 ... times a power of ten.
Real niceStep(Real atLeast) {
    const Real power = std::pow(Real(10), std::floor(std::log10(atLeast)));
    for (const Real factor : {1, 2, 5}) {
        if (factor * power >= atLeast) return factor * power;
    }
    return 10 * power;
}

// One picture of the editor.
class Painting {
public:
    Painting(Drawing& drawing, const Editor& editor)
        : drawing_(drawing), editor_(editor), view_(editor.view()), model_(editor.model()) {}

    void paint() const {
        drawing_.clear(paper);
        grid();
        if (editor_.showsMirror()) mirror();
        if (editor_.showsBoxes()) boxes();
        curve(curveInk, 3, 1);
        if (editor_.showsConstruction()) construction();
        controlPoints();
        gridNumbers();
        if (!editor_.choices().empty()) chooser();
        footer();
        paintPanel(drawing_, editor_);
    }

private:
    Vec2 pixel(const Vec2& world) const { return view_.toPixel(world); }
    Vec2 pixel(const Vec3& world) const { return view_.toPixel(Vec2(world.head<2>())); }

    // Calls draw(place in the world, place in pixels) for the grid's lines across one axis.
    template <typename Draw>
    void gridLines(int axis, const Draw& draw) const {
        const Real step = niceStep(70 / view_.scale());
        const Bounds2 box = sheet();
        const Vec2 a = view_.toWorld(box.min());
        const Vec2 b = view_.toWorld(box.max());
        const Real first = std::ceil(std::min(a[axis], b[axis]) / step);
        const Real last = std::floor(std::max(a[axis], b[axis]) / step);
        for (Real i = first; i <= last; ++i) {
            Vec2 world = Vec2::Zero();
            world[axis] = i * step;
            draw(world[axis], pixel(world)[axis]);
        }
    }

    void grid() const {
        const Bounds2 box = sheet();
        gridLines(0, [&](Real x, Real place) {
            drawing_.line({place, box.min().y()}, {place, box.max().y()}, Stroke{x == 0 ? palette::grid : faint, 1});
        });
        gridLines(1, [&](Real y, Real place) {
            drawing_.line({box.min().x(), place}, {box.max().x(), place}, Stroke{y == 0 ? palette::grid : faint, 1});
        });
        const Real axis = pixel(Vec2(0, 0)).x();
        drawing_.line({axis, box.min().y()}, {axis, box.max().y()}, Stroke{palette::purple.withAlpha(0.8), 1.5, 10});
        drawing_.text({axis + 7, box.min().y() + 20}, "axis", {13, palette::purple});
    }

    // On a light strip along the sheet's edges, so that they can be read whatever lies below.
    void gridNumbers() const {
        const Bounds2 box = sheet();
        constexpr Real strip = 20;
        drawing_.rectangle(Bounds2(Vec2(box.min().x(), box.max().y() - strip), box.max()), paper.withAlpha(0.8));
        drawing_.rectangle(Bounds2(box.min(), Vec2(box.min().x() + 46, box.max().y() - strip)), paper.withAlpha(0.8));
        gridLines(0, [&](Real x, Real place) {
            if (place < 60) return;
            drawing_.text({place, box.max().y() - 6}, number(x), {12, quiet, false, HorizontalAnchor::Centre});
        });
        gridLines(1, [&](Real y, Real place) {
            if (place > box.max().y() - 30) return;
            const TextStyle style{12, quiet, false, HorizontalAnchor::Right, VerticalAnchor::Middle};
            drawing_.text({box.min().x() + 40, place}, number(y), style);
        });
    }

    // As many points as the segment needs to look round; `side` -1 mirrors it in the axis.
    std::vector<Vec2> outline(std::size_t segment, Real side) const {
        const BezierCurve curve = model_.segment(segment);
        Real length = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            length += (pixel(curve.controlPoints()[i + 1]) - pixel(curve.controlPoints()[i])).norm();
        }
        const int count = static_cast<int>(std::clamp(length / 5, Real(8), Real(200)));
        std::vector<Vec2> points;
        for (int i = 0; i <= count; ++i) {
            const Vec3 point = curve.position(Real(i) / count);
            points.push_back(pixel(Vec2(side * point.x(), point.y())));
        }
        return points;
    }

    std::vector<Vec2> wholeOutline(Real side) const {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < model_.segmentCount(); ++i) {
            const auto part = outline(i, side);
            points.insert(points.end(), part.begin(), part.end());
        }
        return points;
    }

    void curve(const Ink& ink, Real width, Real side) const {
        drawing_.polyline(wholeOutline(side), Stroke{ink, width});
    }

    // What the profile looks like turned about the axis, seen from the side.
    void mirror() const {
        std::vector<Vec2> silhouette = wholeOutline(1);
        const std::vector<Vec2> left = wholeOutline(-1);
        silhouette.insert(silhouette.end(), left.rbegin(), left.rend());
        drawing_.polygon(silhouette, palette::sky.withAlpha(0.13));
        curve(curveInk.withAlpha(0.3), 2, -1);
    }

    void box(const Bounds3& bounds, const Stroke& stroke) const {
        Bounds2 shown;
        shown.extend(pixel(Vec3(bounds.min())));
        shown.extend(pixel(Vec3(bounds.max())));
        drawing_.rectangle(shown, stroke);
    }

    void boxes() const {
        const auto spline = model_.spline();
        if (!spline) return;
        box(spline->bounds(), Stroke{boxInk, 1.5, 6});
        if (const auto place = editor_.place(); place && model_.segmentCount() > 1)
            box(exactBounds(model_.segment(place->segment)), Stroke{boxInk.withAlpha(0.45), 1, 3});
    }

    void construction() const {
        const auto place = editor_.place();
        if (!place) return;
        const BezierCurve segment = model_.segment(place->segment);
        const auto levels = segment.construction(place->t);
        const std::array inks = {palette::dark, palette::green, palette::purple};
        for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
            std::vector<Vec2> points;
            for (const Vec3& point : levels[level]) points.push_back(pixel(point));
            drawing_.polyline(points, Stroke{inks[level].withAlpha(level == 0 ? 0.35 : 0.9), level == 0 ? 1.0 : 1.6});
            if (level == 0) continue;
            for (const Vec2& point : points) drawing_.circle(point, 3.2, inks[level]);
        }
        const Vec2 at = pixel(place->point);
        if (const auto tangent = segment.tangent(place->t)) {
            const Vec2 along(tangent->x(), -tangent->y());
            drawing_.arrow(at, at + 64 * along, Stroke{chosenInk, 2.2});
        }
        drawing_.circle(at, 6, paper);
        drawing_.circle(at, 4.6, chosenInk);
    }

    void controlPoints() const {
        for (std::size_t i = 0; i < model_.nodes().size(); ++i) {
            for (const PointKind kind : {PointKind::In, PointKind::Out}) {
                if (!model_.has({i, kind})) continue;
                drawing_.line(pixel(model_.nodes()[i].anchor), pixel(model_.position({i, kind})),
                              Stroke{handleInk.withAlpha(0.55), 1.2});
            }
        }
        for (const PointId& id : model_.points()) {
            if (id.kind != PointKind::Anchor) handle(id);
        }
        for (const PointId& id : model_.points()) {
            if (id.kind == PointKind::Anchor) anchor(id);
        }
    }

    bool isSelected(const PointId& id) const { return editor_.selected() == id; }

    void handle(const PointId& id) const {
        const Vec2 at = pixel(model_.position(id));
        drawing_.circle(at, pointRadius, handleInk);
        drawing_.circle(at, pointRadius - 1.5, isSelected(id) ? chosenInk : paper);
    }

    // Round where the curve is smooth, square where it may have a corner.
    void anchor(const PointId& id) const {
        const Vec2 at = pixel(model_.position(id));
        const Ink inner = isSelected(id) ? chosenInk : paper;
        const auto mark = [&](Real radius, const Ink& ink) {
            if (model_.nodes()[id.node].smooth) return drawing_.circle(at, radius, ink);
            drawing_.rectangle(Bounds2(at.array() - radius * 0.9, at.array() + radius * 0.9), ink);
        };
        if (isSelected(id)) mark(pointRadius + 5, chosenInk.withAlpha(0.35));
        mark(pointRadius + 1.5, curveInk);
        mark(pointRadius - 0.5, inner);
    }

    void chooser() const {
        const Bounds2 first = chooserRow(0);
        const Bounds2 last = chooserRow(editor_.choices().size() - 1);
        const Bounds2 frame(first.min() - Vec2(20, 52), last.max() + Vec2(20, 20));
        drawing_.rectangle(frame, paper);
        drawing_.rectangle(frame, Stroke{palette::dark, 1.5});
        drawing_.text(first.min() + Vec2(8, -18), "Open", {17, palette::text, true});
        for (std::size_t i = 0; i < editor_.choices().size(); ++i) {
            const Bounds2 row = chooserRow(i);
            if (i % 2 == 0) drawing_.rectangle(row, panelPaper);
            drawing_.text(row.min() + Vec2(8, 20),
                          std::to_string(i + 1) + "   " + editor_.choices()[i].filename().string(), {15});
        }
    }

    void footer() const {
        const Real top = sheet().max().y();
        drawing_.rectangle(Bounds2(Vec2(0, top), Vec2(width, height)), panelPaper);
        drawing_.line({0, top}, {Real(width), top}, Stroke{palette::grid, 1.5});
        slider();
        const Ink ink = editor_.complaining() ? palette::vermilion : palette::text;
        drawing_.text({24, Real(height) - 14}, editor_.status(), {15, ink, editor_.complaining()});
    }

    void slider() const {
        const Vec2 start = sliderStart();
        const Vec2 end = sliderEnd();
        const auto count = model_.segmentCount();
        const Real share = count == 0 ? 0 : editor_.u() / Real(count);
        const Vec2 knob = start + share * (end - start);
        drawing_.line(start, end, Stroke{palette::grid, 5});
        if (count == 0) return;
        drawing_.line(start, knob, Stroke{chosenInk, 5});
        if (count <= 40) {
            for (std::size_t i = 0; i <= count; ++i) {
                const Vec2 tick = start + Real(i) / Real(count) * (end - start);
                drawing_.line(tick - Vec2(0, 7), tick + Vec2(0, 7), Stroke{quiet, 1});
            }
        }
        drawing_.circle(knob, 9, chosenInk);
        drawing_.circle(knob, 6.5, paper);
        const auto place = editor_.place();
        const TextStyle style{15, palette::text, false, HorizontalAnchor::Left, VerticalAnchor::Middle};
        std::array<char, 32> t{};
        std::snprintf(t.data(), t.size(), "t = %.2f", place->t);
        drawing_.text({20, start.y()}, t.data(), style);
        drawing_.text(end + Vec2(16, 0), std::to_string(place->segment + 1) + " of " + std::to_string(count), style);
    }

    Drawing& drawing_;
    const Editor& editor_;
    const ViewTransform& view_;
    const EditorModel& model_;
};

}  // namespace

EditorPainter::EditorPainter() : drawing_(width, height, paper, samples) {}

const Drawing& EditorPainter::paint(const Editor& editor) {
    Painting(drawing_, editor).paint();
    return drawing_;
}

}  // namespace caustic
