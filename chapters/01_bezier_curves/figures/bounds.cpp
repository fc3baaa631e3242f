#include <array>

#include "core/text.h"
#include "curve/curve_bounds.h"
#include "curve_with_turns.h"
#include "figures.h"
#include "figures/plane_view.h"

namespace caustic {

namespace {

constexpr int fewSamples = 5;
constexpr Ink hullInk = palette::dark;
constexpr Ink sampledInk = palette::vermilion;
constexpr Ink exactInk = palette::blue;
constexpr TextStyle note{18, palette::text, false, HorizontalAnchor::Left, VerticalAnchor::Middle};

BezierCurve arch() { return BezierCurve({Vec3(0, 1.4, 0), Vec3(-2.2, 5.2, 0), Vec3(8, 5.8, 0), Vec3(5.4, 0, 0)}); }

Bounds3 boxOf(const std::vector<Vec3>& points) {
    Bounds3 box;
    for (const Vec3& point : points) box.extend(point);
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
    const BezierCurve curve = arch();
    const auto samples = samplePoints(curve, fewSamples - 1);
    const Bounds3 hull = boxOf(curve.controlPoints());
    const PlaneView view(flat(hull), Bounds2(Vec2(50, 120), Vec2(650, 620)));
    drawing.rectangle(view.toPixels(exactBounds(curve)), mixed(exactInk, palette::white, 0.9));
    drawing.rectangle(view.toPixels(hull), {hullInk, 2, 9});
    drawing.rectangle(view.toPixels(exactBounds(curve)), {exactInk, 3});
    drawing.rectangle(view.toPixels(boxOf(samples)), {sampledInk, 2.5, 5});
    drawing.polyline(view.toPixels(curve.controlPoints()), {mixed(hullInk, palette::white, 0.5), 1.5});
    drawing.polyline(view.toPixels(samplePoints(curve, 300)), {palette::text, 5});
    for (const Vec3& point : curve.controlPoints()) drawDot(drawing, view.toPixels(point), 6, hullInk);
    for (const Vec3& point : samples) drawDot(drawing, view.toPixels(point), 6, sampledInk);
}

void drawLegend(Drawing& drawing, const Vec2& corner) {
    const std::array<std::pair<Stroke, std::string>, 3> entries = {{
        {{hullInk, 2, 9}, "box of the control points: surely large enough, often far too large"},
        {{sampledInk, 2.5, 5}, "box of five samples: too small"},
        {{exactInk, 3}, "exact box, from the roots of x'(t) and y'(t)"},
    }};
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Vec2 place = corner + Vec2(0, 30 * Real(i));
        drawing.line(place, place + Vec2(40, 0), entries[i].first);
        drawing.text(place + Vec2(54, 0), entries[i].second, note);
    }
}

// x over t: the highest of the samples is the one at 0.5, and the search between its neighbours climbs the wrong hill.
void drawMissedTurn(Drawing& drawing, const Bounds2& area) {
    constexpr Real first = 0.215;
    constexpr Real last = 0.775;
    const std::vector<Real> turns = {0.315, 0.473, 0.568};
    const BezierCurve curve = curveWithTurns(turns);
    const auto x = [&](Real t) { return curve.position(t).x(); };
    const Real found = sampledBounds(curve, fewSamples).max().x();
    const Real top = x(turns[0]);
    const Real bottom = x(0.63);  // the sample at 0.75 lies far below
    const Graph graph(Bounds2(Vec2(first, bottom), Vec2(last, top + 0.12 * (top - bottom))), area);
    const auto level = [&](Real height, const Stroke& stroke) {
        drawing.line(graph.at(first, height), graph.at(last, height), stroke);
    };

    drawing.rectangle(Bounds2(graph.at(0.25, top + 0.12 * (top - bottom)), graph.at(0.75, bottom)),
                      mixed(sampledInk, palette::white, 0.9));
    level(bottom, {palette::dark, 1.5});
    level(top, {exactInk, 2.5});
    level(found, {sampledInk, 2.5, 5});
    std::vector<Vec2> places;
    for (int i = 0; i <= 300; ++i) {
        const Real t = first + (last - first) * i / 300;
        if (x(t) >= bottom) places.push_back(graph.at(t, x(t)));
    }
    drawing.polyline(places, {palette::text, 4});
    for (const Real t : {0.25, 0.5, 0.75}) {
        if (x(t) > bottom) {
            drawing.line(graph.at(t, bottom), graph.at(t, x(t)), {mixed(sampledInk, palette::white, 0.5), 2});
            drawDot(drawing, graph.at(t, x(t)), 8, sampledInk);
        }
        drawing.text(graph.at(t, bottom) + Vec2(0, 26), "t = " + formatReal(t),
                     {18, palette::text, false, HorizontalAnchor::Centre});
    }
    drawDot(drawing, graph.at(turns[0], top), 8, exactInk);
    TextStyle style = note;
    style.horizontal = HorizontalAnchor::Right;
    style.ink = exactInk;
    drawing.text(graph.at(last, top) + Vec2(-8, -18), "the maximum of x", style);
    style.ink = sampledInk;
    drawing.text(graph.at(last, found) + Vec2(-8, -18), "what the search finds", style);
    drawing.text(Vec2(area.min().x(), 690), "shaded: the bracket, between the neighbours of the highest sample", note);
}

}  // namespace

void drawBounds(FigureContext& context) {
    Drawing drawing(1500, 760);
    drawTitle(drawing, {40, 52}, "Three boxes of one curve", "a cubic, with its control polygon and five samples");
    drawBoxes(drawing);
    drawLegend(drawing, {50, 660});
    drawTitle(drawing, {790, 52}, "Two turns between neighbouring samples",
              "the upper part of x over t; five samples over the whole curve");
    drawMissedTurn(drawing, Bounds2(Vec2(810, 120), Vec2(1460, 620)));
    drawing.save(context.output("bounds.png"));
}

}  // namespace caustic
