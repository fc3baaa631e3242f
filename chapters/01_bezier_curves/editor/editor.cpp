#include "editor/editor.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "curve/profile_file.h"
#include "curve/profile_text.h"
#include "editor/editor_layout.h"

namespace caustic {

namespace {

constexpr Real fitMargin = 60;
constexpr Real smallestScale = 1e-90;  // pixels per unit: keeps what the mouse makes far inside largestCoordinate
constexpr Real largestScale = 1e12;

ViewTransform emptyView() {
    return ViewTransform::fit(Bounds2(Vec2(-1, -1), Vec2(9, 7)), editor_layout::sheet(), fitMargin);
}

// "glass.svg#outline" and "glass.svg" are saved as "glass.txt": SVG is read, text is written.
std::filesystem::path savedAs(const ProfileFile& source) {
    std::filesystem::path path = source.file;
    return source.svg ? path.replace_extension(".txt") : path;
}

bool isProfile(const std::filesystem::path& path) { return path.extension() == ".txt" || path.extension() == ".svg"; }

}  // namespace

Editor::Editor(const std::string& name) : view_(emptyView()), file_("profile.txt") {
    if (name.empty()) {
        say("A new curve: double-click to put its points");
        return;
    }
    const std::filesystem::path path = name;
    if (std::filesystem::exists(path) || path.extension() != ".txt") {
        open(name);
        return;
    }
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder)) throw InputError({name, 0}, "", "no such file, and no such folder");
    file_ = path;
    say("A new curve, to be saved as " + path.filename().string() + ": double-click to put its points");
}

void Editor::open(const std::string& name) {
    const ProfileFile source = readProfileFile(name);
    model_ = EditorModel(loadProfile(name), source.file);
    file_ = savedAs(source);
    overwrites_ = !source.svg;
    selected_.reset();
    setU(Real(0.5));
    fit();
    say("Opened " + std::filesystem::path(name).filename().string());
}

void Editor::save() {
    const auto spline = model_.spline();
    if (!spline) return complain("There is no curve to save yet: it needs two points");
    if (!overwrites_ && std::filesystem::exists(file_) && confirming_ != 's') {
        confirming_ = 's';
        return complain(file_.filename().string() + " exists already: s again to replace it");
    }
    saveProfileText(*spline, file_);
    overwrites_ = true;
    model_.markSaved();
    say("Saved as " + file_.string());
}

void Editor::leave() {
    if (!model_.changed() || confirming_ == 'q') {
        finished_ = true;
        return;
    }
    confirming_ = 'q';
    complain("Unsaved changes: s saves them, q again gives them up");
}

void Editor::closeRequested() {
    model_.endDrag();
    leave();
}

void Editor::showChoices() {
    if (model_.changed() && confirming_ != 'o') {
        confirming_ = 'o';
        return complain("Unsaved changes: s saves them, o again gives them up");
    }
    const auto folder = file_.has_parent_path() ? file_.parent_path() : std::filesystem::path(".");
    std::error_code failure;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failure)) {
        if (entry.is_regular_file(failure) && isProfile(entry.path())) choices_.push_back(entry.path());
    }
    if (choices_.empty()) return complain("No profile (.txt, .svg) lies in " + folder.string());
    std::sort(choices_.begin(), choices_.end());
    if (choices_.size() > editor_layout::chooserRows) choices_.resize(editor_layout::chooserRows);
    say("Click a profile, or press its number; Esc goes back");
}

void Editor::choose(std::size_t row) {
    if (row >= choices_.size()) return;
    const std::string name = choices_[row].string();
    choices_.clear();
    open(name);
}

void Editor::say(const std::string& text) {
    status_ = text;
    complaining_ = false;
}

void Editor::complain(const std::string& text) {
    status_ = text;
    complaining_ = true;
}

std::optional<CurvePlace> Editor::place() const {
    const std::size_t count = model_.segmentCount();
    if (count == 0) return std::nullopt;
    const auto segment = std::min(static_cast<std::size_t>(u_), count - 1);
    const Real t = u_ - Real(segment);
    const Vec3 point = model_.segment(segment).position(t);
    return CurvePlace{segment, t, point.head<2>(), 0};
}

void Editor::setU(Real u) { u_ = std::clamp(u, Real(0), Real(model_.segmentCount())); }

void Editor::fit() {
    Bounds2 world;
    for (const PointId& id : model_.points()) world.extend(model_.position(id));
    if (mirror_ && !world.isEmpty()) {
        const Real farthest = std::max(std::abs(world.min().x()), std::abs(world.max().x()));
        world.extend(Vec2(-farthest, world.min().y()));
        world.extend(Vec2(farthest, world.max().y()));
    }
    view_ = world.isEmpty() ? emptyView() : ViewTransform::fit(world, editor_layout::sheet(), fitMargin);
}

void Editor::zoom(Real factor, const Vec2& pixel) {
    const Real scale = std::clamp(view_.scale() * factor, smallestScale, largestScale);
    view_ = ViewTransform(view_.toWorld(pixel), pixel, scale);
}

std::optional<PointId> Editor::pointAt(const Vec2& pixel) const {
    std::optional<PointId> nearest;
    Real smallest = editor_layout::reach;
    for (const PointId& id : model_.points()) {
        // Where an anchor lies on its handle, the anchor is meant.
        const Real bonus = id.kind == PointKind::Anchor ? 1 : 0;
        const Real distance = (view_.toPixel(model_.position(id)) - pixel).norm() - bonus;
        if (distance < smallest) {
            smallest = distance;
            nearest = id;
        }
    }
    return nearest;
}

void Editor::addAt(const Vec2& pixel) {
    adding_ = false;
    const auto there = pointAt(pixel);
    if (there && there->kind == PointKind::Anchor) return complain("There is a point already");
    const Vec2 world = view_.toWorld(pixel);
    const auto place = model_.nearestPlace(world);
    const bool onCurve = place && place->distance * view_.scale() <= editor_layout::reach;
    const bool first = model_.segmentCount() == 0;
    selected_ = onCurve ? model_.split(*place) : model_.add(world);
    setU(first ? Real(0.5) : u_);
    say(onCurve ? "Split the curve here; its shape stays" : "Added a point");
}

void Editor::removeSelected() {
    if (!selected_ || !model_.has(*selected_)) return complain("Click the point to delete first");
    const bool anchor = selected_->kind == PointKind::Anchor;
    model_.remove(*selected_);
    selected_.reset();
    setU(u_);
    say(anchor ? "Deleted a point" : "Drew a handle back into its point");
}

}  // namespace caustic
