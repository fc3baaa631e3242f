#include "figures.h"
#include "figures/plane_view.h"

namespace caustic {

namespace {

// Three quarters of a turn: the tangent goes round, and the hodograph goes round the origin with it.
BezierCurve exampleCurve() {
    return BezierCurve({Vec3(0, 0, 0), Vec3(6, -2.5, 0), Vec3(9, 5, 0), Vec3(1.5, 7.5, 0), Vec3(1.5, 2, 0)});
}

constexpr int tangents = 12;

// The same colour for the same t in both panels.
Ink inkAt(Real t) {
    return t < 0.5 ? mixed(palette::blue, palette::green, 2 * t) : mixed(palette::green, palette::vermilion, 2 * t - 1);
}

void drawColoured(Drawing& drawing, const PlaneView& view, const BezierCurve& curve, Real width) {
    constexpr int pieces = 240;
    const auto places = view.toPixels(samplePoints(curve, pieces));
    for (std::size_t i = 0; i < pieces; ++i) {
        drawing.polyline({places[i], places[i + 1]}, {inkAt(Real(i) / pieces), width});
    }
}

Bounds2 boundsOf(const BezierCurve& curve) {
    Bounds2 box;
    for (const Vec3& point : samplePoints(curve, 200)) box.extend(Vec2(point.head<2>()));
    return box;
}

void drawAxes(Drawing& drawing, const PlaneView& view, const Bounds2& area) {
    const Vec2 origin = view.toPixels(Vec3(0, 0, 0));
    drawing.line({area.min().x(), origin.y()}, {area.max().x(), origin.y()}, {palette::grid, 1.5});
    drawing.line({origin.x(), area.min().y()}, {origin.x(), area.max().y()}, {palette::grid, 1.5});
    drawDot(drawing, origin, 5, palette::dark);
    drawing.text(origin + Vec2(12, 26), "0", {18, palette::dark});
}

}  // namespace

void drawTangentHodograph(FigureContext& context) {
    const BezierCurve curve = exampleCurve();
    const BezierCurve hodograph = curve.hodograph();
    Drawing drawing(1500, 800);
    drawTitle(drawing, {40, 52}, "The curve B(t) with its derivatives",
              "arrows: B'(t), at a tenth of its length; the colour tells t");
    drawTitle(drawing, {840, 52}, "Its hodograph, the curve of B'(t)",
              "the same arrows, moved to the origin, in full length: one degree less");

    const PlaneView left(boundsOf(curve), Bounds2(Vec2(90, 150), Vec2(680, 720)));
    const Bounds2 area(Vec2(820, 130), Vec2(1460, 760));
    Bounds2 world = boundsOf(hodograph);
    world.extend(Vec2(0, 0));
    const PlaneView right(world, Bounds2(area.min() + Vec2(40, 40), area.max() - Vec2(40, 40)));
    drawAxes(drawing, right, area);
    for (int i = 0; i <= tangents; ++i) {
        const Real t = Real(i) / tangents;
        const Vec3 derivative = curve.derivative(t);
        const Stroke stroke{inkAt(t), 2.5};
        const Vec2 from = left.toPixels(curve.position(t));
        drawing.arrow(from, left.toPixels(curve.position(t) + derivative / 10), stroke);
        drawing.arrow(right.toPixels(Vec3(0, 0, 0)), right.toPixels(derivative), {inkAt(t).withAlpha(0.55), 2});
    }
    drawColoured(drawing, left, curve, 5);
    drawColoured(drawing, right, hodograph, 5);
    for (int i = 0; i <= tangents; ++i) {
        const Real t = Real(i) / tangents;
        drawDot(drawing, left.toPixels(curve.position(t)), 6, inkAt(t));
        drawDot(drawing, right.toPixels(hodograph.position(t)), 6, inkAt(t));
    }
    const TextStyle style{20, palette::text, false, HorizontalAnchor::Centre, VerticalAnchor::Middle};
    drawing.text(left.toPixels(curve.position(0)) + Vec2(0, -28), "t = 0", style);
    drawing.text(left.toPixels(curve.position(1)) + Vec2(52, 4), "t = 1", style);
    drawing.text(right.toPixels(hodograph.position(0)) + Vec2(0, 30), "t = 0", style);
    drawing.text(right.toPixels(hodograph.position(1)) + Vec2(52, 4), "t = 1", style);
    drawing.save(context.output("tangent_hodograph.png"));
}

}  // namespace caustic
