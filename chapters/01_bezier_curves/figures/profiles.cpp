#include <array>

#include "curve/curve_bounds.h"
#include "curve/profile_file.h"
#include "figures.h"
#include "figures/plane_view.h"
#include "figures/revolved_view.h"

namespace caustic {

namespace {

constexpr Real ground = 890;  // where the vessels stand, in pixels from the top
constexpr Ink boxInk = palette::purple;

struct Vessel {
    std::string name;
    std::string asset;
    Real axis;   // where its axis stands, in pixels from the left
    Real scale;  // pixels per millimetre
    RevolvedLook look;
};

std::vector<Vessel> vessels() {
    return {
        {"wine glass",
         "assets/profiles/wine_glass.svg",
         230,
         3.05,
         {{0.74, 0.87, 0.92}, {0.06, 0.16, 0.22}, 0.95, true}},
        {"vase", "assets/profiles/vase.svg", 700, 3.05, {{0.05, 0.22, 0.42}, {0.01, 0.04, 0.10}, 0.8, false}},
        {"teacup (drawn larger)",
         "assets/profiles/teacup.svg",
         1285,
         5.2,
         {{0.86, 0.84, 0.80}, {0.30, 0.27, 0.25}, 0.6, false}},
    };
}

Ink inkOf(Continuity continuity) {
    if (continuity == Continuity::C1) return palette::green;
    return continuity == Continuity::G1 ? palette::blue : palette::vermilion;
}

void drawSolid(Drawing& drawing, const Bounds2& place, const BezierSpline& profile, const Vessel& vessel) {
    const Image solid = shadeRevolved(profile, vessel.look, 2 * vessel.scale);
    drawing.image(solid, Bounds2(place.min(), Vec2(place.center().x(), place.max().y())));
}

void drawSegments(Drawing& drawing, const PlaneView& view, const BezierSpline& profile) {
    std::vector<Vec2> outline;
    for (const BezierCurve& segment : profile.segments()) {
        for (const Vec2& point : view.toPixels(samplePoints(segment, 60))) outline.push_back(point);
    }
    drawing.polygon(outline, mixed(palette::sky, palette::white, 0.75));
    for (const BezierCurve& segment : profile.segments()) {
        drawing.rectangle(view.toPixels(exactBounds(segment)), {mixed(boxInk, palette::white, 0.2), 1.4, 5});
    }
    for (const BezierCurve& segment : profile.segments()) {
        drawing.polyline(view.toPixels(segment.controlPoints()), {mixed(palette::dark, palette::white, 0.45), 1.3});
    }
    drawing.polyline(outline, {palette::text, 2.6});
    for (const BezierCurve& segment : profile.segments()) {
        for (const std::size_t i : {1U, 2U})
            drawDot(drawing, view.toPixels(segment.controlPoints()[i]), 3, palette::dark);
    }
}

void drawJoints(Drawing& drawing, const PlaneView& view, const BezierSpline& profile) {
    const auto joints = profile.joints();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Vec3 place = profile.segments()[i].controlPoints().back();
        drawDot(drawing, view.toPixels(place), 5.5, inkOf(joints[i].continuity));
    }
}

void drawVessel(Drawing& drawing, const Vessel& vessel, const BezierSpline& profile) {
    const Bounds3 box = profile.bounds();
    const Vec2 reach(box.max().x() * vessel.scale, box.sizes().y() * vessel.scale);
    const Bounds2 place(Vec2(vessel.axis - reach.x(), ground - reach.y()), Vec2(vessel.axis + reach.x(), ground));
    const PlaneView view(Bounds2(Vec2(-box.max().x(), box.min().y()), Vec2(box.max().x(), box.max().y())), place);
    drawSolid(drawing, place, profile, vessel);
    drawing.line({vessel.axis, place.min().y() - 24}, {vessel.axis, ground + 16}, {palette::dark, 1.3, 9});
    drawSegments(drawing, view, profile);
    drawJoints(drawing, view, profile);
    const std::string label = vessel.name + ", " + std::to_string(profile.segments().size()) + " cubics";
    drawing.text({vessel.axis, ground + 48}, label, {19, palette::text, false, HorizontalAnchor::Centre});
}

void drawLegend(Drawing& drawing, const Vec2& corner) {
    const TextStyle style{18, palette::text, false, HorizontalAnchor::Left, VerticalAnchor::Middle};
    const std::array<std::pair<Ink, std::string>, 2> joints = {
        {{palette::green, "joint, C1: the same derivative"}, {palette::blue, "joint, G1: the same direction"}}};
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Vec2 place = corner + Vec2(22, 32 * Real(i));
        drawDot(drawing, place, 6.5, joints[i].first);
        drawing.text(place + Vec2(34, 0), joints[i].second, style);
    }
    const Vec2 polygon = corner + Vec2(0, 64);
    drawing.line(polygon, polygon + Vec2(44, 0), {mixed(palette::dark, palette::white, 0.45), 1.6});
    drawDot(drawing, polygon + Vec2(22, 0), 4, palette::dark);
    drawing.text(polygon + Vec2(56, 0), "control polygon of a segment", style);
    const Vec2 box = corner + Vec2(0, 96);
    drawing.rectangle(Bounds2(box - Vec2(0, 9), box + Vec2(44, 9)), {mixed(boxInk, palette::white, 0.35), 1.6, 5});
    drawing.text(box + Vec2(56, 0), "exact bounding box of a segment", style);
}

}  // namespace

void drawProfiles(FigureContext& context) {
    Drawing drawing(1600, 970);
    for (const Vessel& vessel : vessels()) {
        drawVessel(drawing, vessel, loadProfile(context.asset(vessel.asset).string()));
    }
    drawTitle(drawing, {1060, 96}, "A few cubics make a vessel",
              "right: the profile, a spline; left: revolved about its axis", 26);
    drawLegend(drawing, {1062, 210});
    drawing.save(context.output("profiles.png"));
}

}  // namespace caustic
