#include "editor/editor_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "editor/editor_layout.h"
#include "editor/editor_style.h"

namespace caustic {

namespace {

using namespace editor_layout;
using namespace editor_style;

class Panel {
public:
    Panel(Drawing& drawing, const Editor& editor) : drawing_(drawing), editor_(editor), model_(editor.model()) {}

    void paint() {
        const Real left = width - panelWidth;
        drawing_.rectangle(Bounds2(Vec2(left, 0), Vec2(width, height)), panelPaper);
        drawing_.line({left, 0}, {left, Real(height)}, Stroke{palette::grid, 1.5});
        cursor_ = {left + 22, 38};
        const std::string name = editor_.file().filename().string();
        drawing_.text(cursor_, name.size() > 24 ? name.substr(0, 21) + "…" : name, {20, palette::text, true});
        cursor_.y() += 20;
        const bool changed = model_.changed();
        drawing_.text(cursor_, changed ? "● not saved" : "saved", {13, changed ? palette::vermilion : quiet});
        cursor_.y() += 14;
        aboutCurve();
        aboutPlace();
        aboutSelection();
        help();
    }

private:
    void heading(const std::string& text) {
        cursor_.y() += 30;
        drawing_.text(cursor_, text, {14, palette::blue, true});
        cursor_.y() += 5;
    }

    void row(const std::string& what, const std::string& value, Real valueColumn = 86) {
        cursor_.y() += 18;
        drawing_.text(cursor_, what, {13, quiet});
        drawing_.text(cursor_ + Vec2(valueColumn, 0), value, {13});
    }

    void aboutCurve() {
        heading("Curve");
        const auto spline = model_.spline();
        row("segments", std::to_string(model_.segmentCount()) + (model_.closed() ? ", closed" : ""));
        if (!spline) return;
        const Bounds3 bounds = spline->bounds();
        row("length", number(spline->length(1e-6 * std::max(bounds.diagonal().norm(), Real(1e-30))).length, 6));
        // The box is padded by the rounding bound; 1e-15 where a reader expects 0 tells nobody anything.
        const Real unit = bounds.diagonal().norm() * 1e-9;
        const auto shown = [&](Real x) { return number(unit > 0 ? std::round(x / unit) * unit : x, 4); };
        row("x from", shown(bounds.min().x()) + " to " + shown(bounds.max().x()));
        row("y from", shown(bounds.min().y()) + " to " + shown(bounds.max().y()));
    }

    void aboutPlace() {
        const auto place = editor_.place();
        if (!place) return;
        heading("At t");
        row("B(t)", pair(place->point));
        const Vec3 derivative = model_.segment(place->segment).derivative(place->t);
        row("B′(t)", pair(derivative.head<2>()));
    }

    void aboutSelection() {
        const auto selected = editor_.selected();
        if (!selected || !model_.has(*selected)) return;
        heading("Selected");
        const char* const kinds[] = {"point ", "handle before point ", "handle after point "};
        row(kinds[static_cast<int>(selected->kind)] + std::to_string(selected->node + 1), "");
        row("at", pair(model_.position(*selected)));
        if (const auto joint = jointAt(selected->node)) row("joint", name(joint->continuity));
    }

    std::optional<Joint> jointAt(std::size_t node) const {
        const auto joints = model_.spline() ? model_.spline()->joints() : std::vector<Joint>();
        if (joints.empty() || (!model_.closed() && node == 0)) return std::nullopt;
        const std::size_t index = (node + model_.nodes().size() - 1) % model_.nodes().size();
        return index < joints.size() ? std::optional(joints[index]) : std::nullopt;
    }

    void help() {
        struct Hint {
            const char* keys;
            const char* what;
        };
        constexpr Hint hints[] = {{"drag", "move a point or a handle"},
                                  {"Ctrl drag", "a handle on its own"},
                                  {"double click", "add; on the curve: split"},
                                  {"a, click", "the same"},
                                  {"d, Del", "delete the selected point"},
                                  {"g", "smooth or corner"},
                                  {"l", "close or open the loop"},
                                  {"z  y", "undo, redo"},
                                  {",  .  [  ]", "t: steps, whole segments"},
                                  {"c  b  m", "construction, box, mirror"},
                                  {"+  −  f", "zoom, fit; right drag pans"},
                                  {"o  s  q", "open, save, quit"}};
        constexpr Real lineHeight = 19;
        cursor_.y() = Real(height) - 54 - lineHeight * Real(std::size(hints));
        heading("Mouse and keys");
        for (const Hint& hint : hints) {
            cursor_.y() += lineHeight;
            drawing_.text(cursor_, hint.keys, {13, palette::text, true});
            drawing_.text(cursor_ + Vec2(98, 0), hint.what, {13, quiet});
        }
    }

    Drawing& drawing_;
    const Editor& editor_;
    const EditorModel& model_;
    Vec2 cursor_ = Vec2::Zero();
};

}  // namespace

void paintPanel(Drawing& drawing, const Editor& editor) { Panel(drawing, editor).paint(); }

}  // namespace caustic
