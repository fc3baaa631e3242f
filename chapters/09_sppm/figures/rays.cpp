#include <algorithm>
#include <cmath>
#include <vector>

#include "core/progress.h"
#include "figures.h"
#include "image/drawing.h"
#include "material/lobe_flags.h"
#include "modeler/objects.h"
#include "modeler/wine_glass.h"
#include "scene/scene.h"
#include "scenes.h"

namespace caustic {

namespace {

constexpr int width = 1100;
constexpr int height = 620;
constexpr Real metre = 9000;  // pixels
constexpr Real left = -0.062;
constexpr Real top = 0.062;

Vec2 onPage(const Vec3& place) { return {(place.x() - left) * metre, (top - place.y()) * metre + 30}; }

// The way of a ray in the plane z = 0, always with the stronger lobe, to the table or out of the picture.
std::vector<Vec3> wayOf(const Scene& scene, Ray ray) {
    std::vector<Vec3> way = {ray.origin};
    MediumStack media;
    RayCounts counts;
    for (int i = 0; i < 24; ++i) {
        Color passed;
        const auto at = scene.follow(ray, media, passed, counts);
        if (!at) {
            way.push_back(ray.at(1));
            break;
        }
        way.push_back(at->point());
        const DeltaLobes lobes = at->bsdf()->deltaLobes(at->wo(), TransportMode::Radiance);
        if (lobes.count == 0) break;
        const BsdfSample& strongest = *std::max_element(
            lobes.begin(), lobes.end(), [](const BsdfSample& a, const BsdfSample& b) { return a.pdfW < b.pdfW; });
        media = at->media(strongest.wi);
        ray = at->spawn(strongest.wi);
    }
    return way;
}

void drawOutline(Drawing& drawing, const BezierSpline& outline) {
    for (const Real side : {-1.0, 1.0}) {
        std::vector<Vec2> points;
        for (const BezierCurve& curve : outline.segments()) {
            for (int i = 0; i <= 60; ++i) {
                const Vec3 p = curve.position(i / 60.0);
                points.push_back(onPage({side * p.x(), p.y(), 0}));
            }
        }
        drawing.polyline(points, {.ink = palette::dark, .width = 2});
    }
}

void drawWay(Drawing& drawing, const std::vector<Vec3>& way, const Ink& ink) {
    std::vector<Vec2> points;
    for (const Vec3& place : way) points.push_back(onPage(place));
    drawing.polyline(points, {.ink = ink, .width = 2.6});
}

}  // namespace

void drawRays(FigureContext& context) {
    const WineGlass glass = {loadOutline(context.asset(glassProfile).string())};
    SceneDescription description;
    description.objects = {glass.glass(),
                           diffuseRectangle({-1, -1e-4, -1}, {0, 0, 2}, {2, 0, 0}, Color::Constant(0.5))};
    const Scene scene(description);
    Drawing drawing(width, height);
    drawOutline(drawing, glass.outline);
    drawing.line(onPage({left, 0, 0}), onPage({-left, 0, 0}), {.ink = palette::dark, .width = 3});
    const Vec3 eye(-0.3, 0.16, 0);
    const auto ray = [&](Real height_) { return Ray{eye, (Vec3(-0.004, height_, 0) - eye).normalized()}; };
    drawWay(drawing, wayOf(scene, ray(0.0210)), palette::blue);
    drawWay(drawing, wayOf(scene, ray(0.0216)), palette::vermilion);
    drawing.text({24, 28}, "Two rays from the eye, 0.1° apart, through the foot of the glass", {.size = 20});
    drawing.save(context.output("rays.png"));
}

}  // namespace caustic
