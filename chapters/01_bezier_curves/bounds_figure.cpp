#include "curve/curve_bounds.h"
#include "curve_with_turns.h"
#include "figures.h"
#include "plane_view.h"

namespace caustic {

namespace {

constexpr int fewSamples = 5;
constexpr Ink hullInk = palette::dark;
constexpr Ink sampledInk = palette::vermilion;
constexpr Ink exactInk = palette::blue;

BezierCurve prettyCurve() {
    return BezierCurve({Vec3(0.8, 0, 0), Vec3(-1.6, 4.2, 0), Vec3(5.2, 6.2, 0), Vec3(7.2, -3, 0), Vec3(4.6, 3.4, 0)});
}

Bounds3 hullBox(const BezierCurve& curve) {
    Bounds3 box;
    for (const Vec3& point : curve.controlPoints()) box.extend(point);
    return box;
}

Bounds2 flat(const Bounds3& box) { return {box.min().head<2>(), box.max().head<2>()}; }

// A graph with x to the right and y up, each at a scale of its own.
class Graph {
public:
    Graph(const Bounds2& world, const Bounds2& pixels) : world_(world), pixels_(pixels) {}
    Vec2 at(Real x, Real y) const {
        const Vec2 share = (Vec2(x, y) - world_.min()).cwiseQuotient(world_.sizes());
        return {pixels_.min().x() + share.x() * pixels_.sizes().x(),
                pixels_.max().y() - share.y() * pixels_.sizes().y()};
    }

private:
    Bounds2 world_;
    Bounds2 pixels_;
};

void drawBoxes(Drawing& drawing) {
    const BezierCurve curve = prettyCurve();
    const PlaneView view(flat(hullBox(curve)), Bounds2(Vec2(60, 150), Vec2(720, 690)));
    drawing.rectangle(view.toPixels(hullBox(curve)), {hullInk, 2, 9});
    drawing.rectangle(view.toPixels(exactBounds(curve)), exactInk.withAlpha(0.10));
    drawing.rectangle(view.toPixels(exactBounds(curve)), {exactInk, 3});
    drawing.polyline(view.toPixels(curve.controlPoints()), {mixed(hullInk, palette::white, 0.4), 1.5});
    drawing.polyline(view.toPixels(samplePoints(curve, 300)), {palette::text, 5});
    for (const Vec3& point : curve.controlPoints()) drawDot(drawing, view.toPixels(point), 6, hullInk);
}

}  // namespace

void drawBounds(FigureContext& context) {
    Drawing drawing(1500, 800);
    drawBoxes(drawing);
    drawing.save(context.output("bounds.png"));
}

}  // namespace caustic
