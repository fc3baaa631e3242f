#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "curve/bezier_spline.h"
#include "math/vector.h"

namespace caustic {

/// A place where two cubic segments meet, with the control points on either side of it. In the profile's unit.
struct EditorNode {
    Vec2 anchor;          ///< on the curve
    Vec2 in;              ///< control point before it; none at the beginning of an open curve
    Vec2 out;             ///< control point after it; none at the end of an open curve
    bool smooth = false;  ///< whether in, anchor and out are kept on one line (G1)

    friend bool operator==(const EditorNode&, const EditorNode&) = default;
};

/// The three control points of a node.
enum class PointKind { Anchor, In, Out };

/// Names a control point.
struct PointId {
    std::size_t node = 0;
    PointKind kind = PointKind::Anchor;

    friend bool operator==(const PointId&, const PointId&) = default;
};

/// A point of the curve.
struct CurvePlace {
    std::size_t segment = 0;
    Real t = 0;         ///< in [0, 1] on that segment
    Vec2 point;         ///< where it is
    Real distance = 0;  ///< from the point that was asked about
};

/// What is edited: a flat piecewise cubic curve, open or closed, with a history. Knows no window.
///
/// Every change is one step of undo; a drag is one step, however long. The last `mostSteps` steps are kept.
class EditorModel {
public:
    static constexpr std::size_t mostSegments = 2000;  ///< more can't be picked with a mouse, nor redrawn fast
    static constexpr std::size_t mostSteps = 500;

    /// An empty sheet.
    EditorModel() = default;

    /// @param file  what errors call it
    /// @throws InputError when the spline is not flat (z = 0), its segments don't meet, or there are too many
    EditorModel(const BezierSpline& spline, const std::string& file);

    /// The curve's nodes in order; when it is closed, a segment leads from the last to the first.
    const std::vector<EditorNode>& nodes() const { return now_.nodes; }
    bool closed() const { return now_.closed; }
    std::size_t segmentCount() const;
    /// Segment i, in the plane z = 0.
    BezierCurve segment(std::size_t i) const;
    /// The curve; nothing while there is no segment.
    std::optional<BezierSpline> spline() const;

    /// The control points, in the order of the curve.
    std::vector<PointId> points() const;
    /// Whether there is such a control point.
    bool has(const PointId& id) const;
    Vec2 position(const PointId& id) const;
    /// The point of the curve next to `point`, up to 1e-9 of a segment's t; nothing while there is no segment.
    std::optional<CurvePlace> nearestPlace(const Vec2& point) const;

    /// A drag: begin, any number of moves, end. An anchor takes its handles along; the handle of a smooth node turns
    /// its partner, unless it goes `alone`, which makes the node a corner.
    void beginDrag(const PointId& id);
    void dragTo(const Vec2& position, bool alone);
    void endDrag();
    bool dragging() const { return drag_.has_value(); }

    /// Adds a node at the nearer end of an open curve, so that the curve goes on smoothly; bends the nearest segment of
    /// a closed one. The new node's anchor.
    PointId add(const Vec2& position);
    /// Adds a node on the curve, which keeps its shape (de Casteljau's split). The new node's anchor.
    PointId split(const CurvePlace& place);
    /// Removes a node (its neighbours' handles stay), or draws a handle back into its anchor.
    void remove(const PointId& id);
    /// Makes a smooth node a corner, or lines its handles up.
    void toggleSmooth(std::size_t node);
    /// Closes the curve by a segment from its end to its beginning, or opens it there. Needs two nodes at least.
    void toggleClosed();

    /// What was taken back or done again, as in "move"; nothing when there was nothing.
    std::optional<std::string> undo();
    std::optional<std::string> redo();

    /// Whether it differs from what was saved last.
    bool changed() const { return now_ != saved_; }
    void markSaved() { saved_ = now_; }

private:
    struct Shape {
        std::vector<EditorNode> nodes;
        bool closed = false;

        friend bool operator==(const Shape&, const Shape&) = default;
    };
    struct Step {
        std::string what;
        Shape shape;  // before it, in past_; after it, in future_
    };
    struct Drag {
        PointId id;
        Shape before;
    };

    void remember(const std::string& what, Shape before);
    void checkRoom() const;
    std::size_t next(std::size_t node) const { return (node + 1) % now_.nodes.size(); }
    std::size_t previous(std::size_t node) const { return (node + now_.nodes.size() - 1) % now_.nodes.size(); }
    void align(std::size_t node);

    Shape now_;
    Shape saved_;
    std::deque<Step> past_;
    std::vector<Step> future_;
    std::optional<Drag> drag_;
};

}  // namespace caustic
