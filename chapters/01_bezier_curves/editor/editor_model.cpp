#include "editor/editor_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

Vec3 inPlane(const Vec2& point) { return {point.x(), point.y(), 0}; }
Vec2 flat(const Vec3& point) { return point.head<2>(); }

// A handle of the length of `handle` - `anchor` that points away from `partner`; `handle` itself when there is no line.
Vec2 opposite(const Vec2& anchor, const Vec2& partner, const Vec2& handle) {
    const Real length = (partner - anchor).norm();
    if (!(length > 0)) return handle;
    return anchor - (partner - anchor) * ((handle - anchor).norm() / length);
}

Vec2& pointOf(EditorNode& node, PointKind kind) {
    if (kind == PointKind::Anchor) return node.anchor;
    return kind == PointKind::In ? node.in : node.out;
}

// How far along the segment's t the nearest point lies, between a and b: a golden-section search.
Real nearestParameter(const BezierCurve& curve, const Vec3& point, Real a, Real b) {
    const Real golden = (std::sqrt(Real(5)) - 1) / 2;
    while (b - a > 1e-9) {
        const Real left = b - golden * (b - a);
        const Real right = a + golden * (b - a);
        const bool leftIsNearer =
            (curve.position(left) - point).squaredNorm() < (curve.position(right) - point).squaredNorm();
        (leftIsNearer ? b : a) = leftIsNearer ? right : left;
    }
    return (a + b) / 2;
}

CurvePlace nearestOnSegment(const BezierCurve& curve, std::size_t segment, const Vec2& point) {
    constexpr int samples = 32;
    const Vec3 place = inPlane(point);
    int nearest = 0;
    Real smallest = std::numeric_limits<Real>::infinity();
    for (int i = 0; i <= samples; ++i) {
        const Real distance = (curve.position(Real(i) / samples) - place).squaredNorm();
        if (distance < smallest) {
            smallest = distance;
            nearest = i;
        }
    }
    const Real t = nearestParameter(curve, place, Real(std::max(nearest - 1, 0)) / samples,
                                    Real(std::min(nearest + 1, samples)) / samples);
    const Vec2 found = flat(curve.position(t));
    return {segment, t, found, (found - point).norm()};
}

void checkFlat(const BezierSpline& spline, const std::string& file) {
    for (const BezierCurve& segment : spline.segments()) {
        for (const Vec3& point : segment.controlPoints()) {
            if (point.z() != 0)
                throw InputError({file, 0}, formatReal(point.z()), "the editor's sheet is flat: every z must be 0");
        }
    }
}

}  // namespace

EditorModel::EditorModel(const BezierSpline& spline, const std::string& file) {
    checkFlat(spline, file);
    const std::size_t count = spline.segments().size();
    if (count > mostSegments)
        throw InputError({file, 0}, std::to_string(count),
                         "the editor takes at most " + std::to_string(mostSegments) + " segments");
    const std::vector<Joint> joints = spline.joints();
    std::vector<EditorNode>& nodes = now_.nodes;
    for (std::size_t i = 0; i < count; ++i) {
        const auto& p = spline.segments()[i].controlPoints();
        if (i == 0) nodes.push_back({flat(p[0]), flat(p[0]), flat(p[1])});
        nodes.back().out = flat(p[1]);
        nodes.push_back({flat(p[3]), flat(p[2]), flat(p[3])});
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i].continuity == Continuity::Gap)
            throw InputError({file, 0}, formatReal(joints[i].distance),
                             "segment " + std::to_string(i + 1) + " doesn't lead to the next one: there is a gap");
        // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): without segments there are no joints.
        nodes[(i + 1) % count].smooth = joints[i].continuity >= Continuity::G1;
    }
    if (spline.closed()) {  // the last node is the first one, met again
        nodes.front().in = nodes.back().in;
        nodes.pop_back();
        now_.closed = true;
    } else {
        nodes.back().smooth = true;
        nodes.front().smooth = true;
    }
    saved_ = now_;
}

std::size_t EditorModel::segmentCount() const {
    const std::size_t count = now_.nodes.size();
    return now_.closed || count == 0 ? count : count - 1;
}

BezierCurve EditorModel::segment(std::size_t i) const {
    const EditorNode& from = now_.nodes[i];
    const EditorNode& to = now_.nodes[next(i)];
    return BezierCurve({inPlane(from.anchor), inPlane(from.out), inPlane(to.in), inPlane(to.anchor)});
}

std::optional<BezierSpline> EditorModel::spline() const {
    if (segmentCount() == 0) return std::nullopt;
    std::vector<BezierCurve> segments;
    for (std::size_t i = 0; i < segmentCount(); ++i) segments.push_back(segment(i));
    return BezierSpline(std::move(segments), now_.closed);
}

std::vector<PointId> EditorModel::points() const {
    std::vector<PointId> ids;
    for (std::size_t node = 0; node < now_.nodes.size(); ++node) {
        for (const PointKind kind : {PointKind::In, PointKind::Anchor, PointKind::Out}) {
            if (has({node, kind})) ids.push_back({node, kind});
        }
    }
    return ids;
}

bool EditorModel::has(const PointId& id) const {
    const std::size_t count = now_.nodes.size();
    if (id.node >= count) return false;
    if (id.kind == PointKind::Anchor || now_.closed) return true;
    return id.kind == PointKind::In ? id.node > 0 : id.node + 1 < count;
}

Vec2 EditorModel::position(const PointId& id) const {
    EditorNode node = now_.nodes[id.node];
    return pointOf(node, id.kind);
}

std::optional<CurvePlace> EditorModel::nearestPlace(const Vec2& point) const {
    std::optional<CurvePlace> nearest;
    for (std::size_t i = 0; i < segmentCount(); ++i) {
        const CurvePlace place = nearestOnSegment(segment(i), i, point);
        if (!nearest || place.distance < nearest->distance) nearest = place;
    }
    return nearest;
}

void EditorModel::beginDrag(const PointId& id) { drag_ = Drag{id, now_}; }

void EditorModel::dragTo(const Vec2& position, bool alone) {
    if (!drag_) return;
    EditorNode& node = now_.nodes[drag_->id.node];
    const PointKind kind = drag_->id.kind;
    if (kind == PointKind::Anchor) {
        const Vec2 shift = position - node.anchor;
        node.in += shift;
        node.out += shift;
        node.anchor = position;
        return;
    }
    pointOf(node, kind) = position;
    if (alone) node.smooth = false;
    if (!node.smooth) return;
    if (kind == PointKind::In) node.out = opposite(node.anchor, node.in, node.out);
    if (kind == PointKind::Out) node.in = opposite(node.anchor, node.out, node.in);
}

void EditorModel::endDrag() {
    if (!drag_) return;
    Drag drag = std::move(*drag_);
    drag_.reset();
    if (drag.before != now_) remember("move", std::move(drag.before));
}

PointId EditorModel::add(const Vec2& position) {
    checkRoom();
    if (now_.closed) {
        const PointId id = split(*nearestPlace(position));
        past_.back().what = "add";
        EditorNode& node = now_.nodes[id.node];
        const Vec2 shift = position - node.anchor;
        node.in += shift;
        node.out += shift;
        node.anchor = position;
        return id;
    }
    remember("add", now_);
    std::vector<EditorNode>& nodes = now_.nodes;
    if (nodes.empty()) {
        nodes.push_back({position, position, position, true});
        return {0, PointKind::Anchor};
    }
    const bool atEnd =
        nodes.size() == 1 || (position - nodes.back().anchor).norm() <= (position - nodes.front().anchor).norm();
    EditorNode& from = atEnd ? nodes.back() : nodes.front();
    Vec2& leaving = atEnd ? from.out : from.in;
    const Vec2& arriving = atEnd ? from.in : from.out;
    // A third of the way along the direction in which the curve ends; straight ahead where it has none.
    const Vec2 ahead = (position - from.anchor) / 3;
    const bool hasDirection = nodes.size() > 1 && from.smooth && (from.anchor - arriving).norm() > 0;
    leaving = hasDirection ? opposite(from.anchor, arriving, from.anchor + ahead) : Vec2(from.anchor + ahead);
    const Vec2 back = position + (leaving - position) * Real(0.4);
    const Vec2 forth = 2 * position - back;
    const EditorNode node{position, atEnd ? back : forth, atEnd ? forth : back, true};
    nodes.insert(atEnd ? nodes.end() : nodes.begin(), node);
    return {atEnd ? nodes.size() - 1 : 0, PointKind::Anchor};
}

PointId EditorModel::split(const CurvePlace& place) {
    checkRoom();
    const auto [left, right] = segment(place.segment).split(place.t);
    remember("add", now_);
    std::vector<EditorNode>& nodes = now_.nodes;
    nodes[next(place.segment)].in = flat(right.controlPoints()[2]);
    nodes[place.segment].out = flat(left.controlPoints()[1]);
    const EditorNode node{flat(right.controlPoints()[0]), flat(left.controlPoints()[2]), flat(right.controlPoints()[1]),
                          true};
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(place.segment) + 1, node);
    return {place.segment + 1, PointKind::Anchor};
}

void EditorModel::remove(const PointId& id) {
    if (!has(id)) return;
    remember("delete", now_);
    if (id.kind == PointKind::Anchor) {
        now_.nodes.erase(now_.nodes.begin() + static_cast<std::ptrdiff_t>(id.node));
        if (now_.nodes.size() < 2) now_.closed = false;
        return;
    }
    EditorNode& node = now_.nodes[id.node];
    pointOf(node, id.kind) = node.anchor;
    node.smooth = false;
}

void EditorModel::toggleSmooth(std::size_t node) {
    if (node >= now_.nodes.size()) return;
    remember(now_.nodes[node].smooth ? "corner" : "smooth", now_);
    now_.nodes[node].smooth = !now_.nodes[node].smooth;
    if (now_.nodes[node].smooth) align(node);
}

// Lays both handles along the mean of their directions, or along the line between the neighbours when they have none.
// A handle that was drawn back gets a third of the way to its neighbour.
void EditorModel::align(std::size_t index) {
    EditorNode& node = now_.nodes[index];
    const Vec2 before = has({index, PointKind::In}) ? now_.nodes[previous(index)].anchor : node.anchor;
    const Vec2 after = has({index, PointKind::Out}) ? now_.nodes[next(index)].anchor : node.anchor;
    Vec2 direction = (node.anchor - node.in).normalized() + (node.out - node.anchor).normalized();
    if (direction.norm() < 1e-6) direction = after - before;
    if (!(direction.norm() > 0)) return;
    direction.normalize();
    const auto length = [&](const Vec2& handle, const Vec2& neighbour) {
        const Real own = (handle - node.anchor).norm();
        return own > 0 ? own : (neighbour - node.anchor).norm() / 3;
    };
    node.in = node.anchor - direction * length(node.in, before);
    node.out = node.anchor + direction * length(node.out, after);
}

void EditorModel::toggleClosed() {
    if (now_.nodes.size() < 2) return;
    remember(now_.closed ? "open" : "close", now_);
    now_.closed = !now_.closed;
}

std::optional<std::string> EditorModel::undo() {
    if (past_.empty() || drag_) return std::nullopt;
    Step step = std::move(past_.back());
    past_.pop_back();
    std::swap(now_, step.shape);
    future_.push_back(std::move(step));
    return future_.back().what;
}

std::optional<std::string> EditorModel::redo() {
    if (future_.empty() || drag_) return std::nullopt;
    Step step = std::move(future_.back());
    future_.pop_back();
    std::swap(now_, step.shape);
    past_.push_back(std::move(step));
    return past_.back().what;
}

void EditorModel::remember(const std::string& what, Shape before) {
    past_.push_back({what, std::move(before)});
    if (past_.size() > mostSteps) past_.pop_front();
    future_.clear();
}

void EditorModel::checkRoom() const {
    if (segmentCount() >= mostSegments)
        throw InputError({"editor", 0}, "", "takes at most " + std::to_string(mostSegments) + " segments");
}

}  // namespace caustic
