#include "core/text.h"
#include "example_curves.h"
#include "figures.h"
#include "figures/plane_view.h"

namespace caustic {

namespace {

constexpr Ink levelInks[] = {palette::dark, palette::blue, palette::green, palette::vermilion};

void drawCurveUpTo(Drawing& drawing, const PlaneView& view, const BezierCurve& curve, Real t, Real width) {
    drawing.polyline(view.toPixels(samplePoints(curve, 200)), {mixed(palette::vermilion, palette::white, 0.72), width});
    drawing.polyline(view.toPixels(samplePoints(curve, 200, 0, t)), {palette::vermilion, width});
}

void drawLevels(Drawing& drawing, const PlaneView& view, const std::vector<std::vector<Vec3>>& levels, Real width) {
    for (std::size_t r = 0; r + 1 < levels.size(); ++r) {
        drawing.polyline(view.toPixels(levels[r]), {levelInks[r], width});
    }
    for (std::size_t r = 0; r < levels.size(); ++r) {
        const Real radius = (r + 1 == levels.size() ? 4 : 2.5) * width;
        for (const Vec2& place : view.toPixels(levels[r])) drawDot(drawing, place, radius, levelInks[r]);
    }
}

void drawLabels(Drawing& drawing, const PlaneView& view, const std::vector<std::vector<Vec3>>& levels) {
    // Where each name has room, in pixels from its point.
    const std::vector<std::vector<Vec2>> offsets = {{{-4, 34}, {-8, -30}, {14, -30}, {14, 34}},
                                                    {{-36, -12}, {0, -32}, {38, -6}},
                                                    {{-40, -16}, {40, -22}},
                                                    {{4, 36}}};
    for (std::size_t r = 0; r < levels.size(); ++r) {
        for (std::size_t i = 0; i < levels[r].size(); ++i) {
            const Vec2 place = view.toPixels(levels[r][i]) + offsets[r][i];
            drawSymbol(drawing, place, "P", std::to_string(i), std::to_string(r), levelInks[r], 26);
        }
    }
}

// What the proportion means, on the first line.
void drawProportion(Drawing& drawing, const PlaneView& view, const std::vector<std::vector<Vec3>>& levels) {
    const TextStyle style{22, palette::blue, false, HorizontalAnchor::Right, VerticalAnchor::Middle};
    const Vec2 divided = view.toPixels(levels[1][0]);
    drawing.text((view.toPixels(levels[0][0]) + divided) / 2 + Vec2(-16, 0), "t", style);
    drawing.text((view.toPixels(levels[0][1]) + divided) / 2 + Vec2(-16, 0), "1 − t", style);
}

void drawLegend(Drawing& drawing, const Vec2& corner) {
    const std::vector<std::string> names = {"control points", "first round", "second round",
                                            "third round: the point B(t)"};
    for (std::size_t r = 0; r < names.size(); ++r) {
        const Vec2 place = corner + Vec2(0, 30 * Real(r));
        drawDot(drawing, place, 7, levelInks[r]);
        drawing.text(place + Vec2(18, 0), names[r],
                     {18, palette::text, false, HorizontalAnchor::Left, VerticalAnchor::Middle});
    }
}

}  // namespace

void drawDeCasteljau(FigureContext& context) {
    const BezierCurve curve = archCurve();
    const Bounds2 world(Vec2(0, 0), Vec2(6, 4));
    Drawing drawing(1500, 860);
    drawTitle(drawing, {40, 52}, "De Casteljau's construction at t = 0.4",
              "each round divides every line in the proportion t : 1 − t; three rounds lead from four points to one");

    const PlaneView large(world, Bounds2(Vec2(70, 150), Vec2(980, 770)));
    drawCurveUpTo(drawing, large, curve, 0.4, 6);
    drawLevels(drawing, large, curve.construction(0.4), 3);
    drawLabels(drawing, large, curve.construction(0.4));
    drawProportion(drawing, large, curve.construction(0.4));
    drawLegend(drawing, {340, 640});

    const std::vector<Real> moments = {0.15, 0.3, 0.6, 0.85};
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const Real top = 120 + 182 * Real(i);
        const PlaneView small(world, Bounds2(Vec2(1190, top), Vec2(1450, top + 160)));
        drawCurveUpTo(drawing, small, curve, moments[i], 3);
        drawLevels(drawing, small, curve.construction(moments[i]), 1.5);
        drawing.text({1080, top + 80}, "t = " + formatReal(moments[i]),
                     {20, palette::text, false, HorizontalAnchor::Left, VerticalAnchor::Middle});
    }
    drawing.save(context.output("de_casteljau.png"));
}

}  // namespace caustic
