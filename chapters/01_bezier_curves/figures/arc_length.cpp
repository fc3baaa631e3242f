#include <algorithm>

#include "curve/arc_length.h"
#include "example_curves.h"
#include "figures.h"
#include "figures/plane_view.h"

namespace caustic {

namespace {

constexpr int pieces = 24;
constexpr Real tolerance = 1e-9;  // of lengths, in the curve's unit: far below a pixel

std::vector<Real> evenParameters() {
    std::vector<Real> parameters;
    for (int i = 0; i <= pieces; ++i) parameters.push_back(Real(i) / pieces);
    return parameters;
}

std::vector<Real> pieceLengths(const BezierCurve& curve, const std::vector<Real>& parameters) {
    std::vector<Real> lengths;
    for (std::size_t i = 1; i < parameters.size(); ++i) {
        lengths.push_back(gaussLength(curve, tolerance, parameters[i - 1], parameters[i]).length);
    }
    return lengths;
}

void drawBeads(Drawing& drawing, const PlaneView& view, const BezierCurve& curve, const std::vector<Real>& parameters,
               const Ink& ink) {
    drawing.polyline(view.toPixels(samplePoints(curve, 300)), {mixed(ink, palette::white, 0.6), 5});
    for (const Real t : parameters) drawDot(drawing, view.toPixels(curve.position(t)), 7, ink);
}

// A bar for each piece, as high as the piece is long.
void drawBars(Drawing& drawing, const Bounds2& area, const std::vector<Real>& lengths, Real longest, const Ink& ink) {
    const Real step = area.sizes().x() / Real(lengths.size());
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const Real left = area.min().x() + step * Real(i);
        const Real top = area.max().y() - area.sizes().y() * lengths[i] / longest;
        drawing.rectangle(Bounds2(Vec2(left + 2, top), Vec2(left + step - 2, area.max().y())), ink);
    }
    drawing.line({area.min().x(), area.max().y()}, area.max(), {palette::dark, 1.5});
    drawing.text(Vec2(area.min().x(), area.max().y() + 28), "length of each piece, from the first to the last",
                 {17, palette::dark});
}

}  // namespace

void drawArcLength(FigureContext& context) {
    const BezierCurve curve = unevenCurve();
    Bounds2 world;
    for (const Vec3& point : samplePoints(curve, 300)) world.extend(Vec2(point.head<2>()));
    const std::vector<Real> byParameter = evenParameters();
    const std::vector<Real> byLength = evenlySpaced(curve, pieces);
    const std::vector<Real> uneven = pieceLengths(curve, byParameter);
    const Real longest = *std::max_element(uneven.begin(), uneven.end());

    Drawing drawing(1500, 640);
    drawTitle(drawing, {40, 52}, "24 even steps in t", "crowded where the curve is slow, sparse where it is fast");
    drawTitle(drawing, {790, 52}, "24 even steps in arc length", "every piece is as long as the others");
    drawBeads(drawing, PlaneView(world, Bounds2(Vec2(60, 115), Vec2(710, 375))), curve, byParameter,
              palette::vermilion);
    drawBeads(drawing, PlaneView(world, Bounds2(Vec2(810, 115), Vec2(1460, 375))), curve, byLength, palette::blue);
    drawBars(drawing, Bounds2(Vec2(60, 430), Vec2(710, 585)), uneven, longest, palette::vermilion);
    drawBars(drawing, Bounds2(Vec2(810, 430), Vec2(1460, 585)), pieceLengths(curve, byLength), longest, palette::blue);
    drawing.save(context.output("arc_length.png"));
}

}  // namespace caustic
