#include "editor/editor.h"

#include <cmath>

#include "core/error.h"
#include "editor/editor_layout.h"

namespace caustic {

namespace {

constexpr Real zoomStep = 1.25;

}  // namespace

void Editor::leftDown(const Vec2& pixel) {
    if (editor_layout::onSlider(pixel)) {
        sliding_ = true;
        return setU(editor_layout::sliderShare(pixel) * Real(model_.segmentCount()));
    }
    if (!editor_layout::sheet().contains(pixel)) return;
    if (adding_) return addAt(pixel);
    selected_ = pointAt(pixel);
    if (selected_) {
        model_.beginDrag(*selected_);
        grip_ = view_.toPixel(model_.position(*selected_)) - pixel;
        return;
    }
    const auto place = model_.nearestPlace(view_.toWorld(pixel));
    if (place && place->distance * view_.scale() <= editor_layout::reach) setU(Real(place->segment) + place->t);
}

void Editor::mouse(MouseAction action, const Vec2& pixel, bool alone) try {
    if (!choices_.empty()) {
        if (action != MouseAction::LeftDown) return;
        for (std::size_t row = 0; row < choices_.size(); ++row) {
            if (editor_layout::chooserRow(row).contains(pixel)) return choose(row);
        }
        return;
    }
    switch (action) {
        case MouseAction::LeftDown:
            confirming_ = 0;
            return leftDown(pixel);
        case MouseAction::Move:
            if (sliding_) setU(editor_layout::sliderShare(pixel) * Real(model_.segmentCount()));
            if (model_.dragging()) model_.dragTo(view_.toWorld(pixel + grip_), alone);
            if (panningFrom_) {
                view_ = ViewTransform(view_.toWorld(*panningFrom_), pixel, view_.scale());
                panningFrom_ = pixel;
            }
            return;
        case MouseAction::LeftUp:
            sliding_ = false;
            return model_.endDrag();
        case MouseAction::LeftDouble:
            if (editor_layout::sheet().contains(pixel) && !pointAt(pixel)) addAt(pixel);
            return;
        case MouseAction::PanDown:
            panningFrom_ = pixel;
            return;
        case MouseAction::PanUp:
            panningFrom_.reset();
            return;
    }
} catch (const InputError& error) {
    complain(error.what());
}

void Editor::key(int code) try {
    if (model_.dragging()) return;
    const int confirmed = confirming_;
    act(code);
    if (confirming_ == confirmed) confirming_ = 0;  // any other key, or the second press: the question is answered
} catch (const InputError& error) {
    confirming_ = 0;
    complain(error.what());
}

void Editor::act(int code) {
    if (!choices_.empty()) return answer(code);
    switch (code) {
        case 'a':
            adding_ = true;
            return say("Click where the new point goes; on the curve it splits it");
        case 'd':
        case editor_key::backspace:
        case editor_key::remove:
            return removeSelected();
        case 'g':
            if (!selected_) return complain("Click a point first");
            model_.toggleSmooth(selected_->node);
            return say(model_.nodes()[selected_->node].smooth ? "Smooth: its handles stay on one line" : "A corner");
        case 'l':
            model_.toggleClosed();
            setU(u_);
            return say(model_.closed() ? "Closed" : "Opened");
        case 'z': {
            const auto what = model_.undo();
            selected_.reset();
            setU(u_);
            return say(what ? "Undone: " + *what : "Nothing to undo");
        }
        case 'y': {
            const auto what = model_.redo();
            selected_.reset();
            setU(u_);
            return say(what ? "Done again: " + *what : "Nothing to do again");
        }
        case 's':
            return save();
        case 'o':
            return showChoices();
        case 'q':
            return leave();
        case editor_key::escape:
            adding_ = false;
            selected_.reset();
            return say("");
        default:
            return look(code);
    }
}

void Editor::answer(int code) {
    if (code == editor_key::escape) {
        choices_.clear();
        return say("");
    }
    if (code >= '1' && code <= '9') choose(static_cast<std::size_t>(code - '1'));
}

void Editor::look(int code) {
    const Real step = Real(0.01);
    switch (code) {
        case ',':
            return setU(u_ - step);
        case '.':
            return setU(u_ + step);
        case '[':
            return setU(std::ceil(u_) - 1);
        case ']':
            return setU(std::floor(u_) + 1);
        case 'b':
            boxes_ = !boxes_;
            return;
        case 'c':
            construction_ = !construction_;
            return;
        case 'm':
            mirror_ = !mirror_;
            return fit();
        case 'f':
            return fit();
        case '+':
        case '=':
            return zoom(zoomStep, editor_layout::sheet().center());
        case '-':
            return zoom(1 / zoomStep, editor_layout::sheet().center());
        default:
            return;
    }
}

}  // namespace caustic
