#include <array>
#include <memory>
#include <string>

#include "core/progress.h"
#include "curve/profile_file.h"
#include "figures.h"
#include "figures/lit_color.h"
#include "image/drawing.h"
#include "image/ray_view.h"
#include "revolution_cases.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

namespace {

struct Body {
    std::string name;
    SurfaceOfRevolution surface;
    Color color;
};

std::vector<Body> bodies(FigureContext& context) {
    const auto fromSvg = [&](const std::string& name) {
        return SurfaceOfRevolution(loadProfile(context.asset("assets/profiles/" + name).string()));
    };
    std::vector<Body> all;
    all.push_back({"vase: 8 cubics", fromSvg("vase.svg"), Color(0.08, 0.3, 0.62)});
    all.push_back({"teacup", fromSvg("teacup.svg"), Color(0.75, 0.7, 0.62)});
    for (NamedProfile& named : difficultProfiles()) {
        if (named.name == "degree 12")
            all.push_back({"one curve of degree 12", SurfaceOfRevolution(named.profile), Color(0.7, 0.28, 0.1)});
        if (named.name == "negative radius")
            all.push_back({"radius through zero, twice", SurfaceOfRevolution(named.profile), Color(0.1, 0.5, 0.35)});
    }
    return all;
}

}  // namespace

void drawBodies(FigureContext& context) {
    constexpr int tile = 400;
    constexpr int gap = 12;
    constexpr int top = 50;
    const auto all = bodies(context);
    const int samples = context.byQuality(2, 5);
    Drawing drawing(gap + static_cast<int>(all.size()) * (tile + gap), top + tile + gap);
    context.progress().expect(static_cast<std::int64_t>(all.size()));
    Real x = gap;
    for (const Body& body : all) {
        const Bounds3 box = body.surface.bounds();
        const Real size = box.diagonal().norm();
        const RayView view = {box.center() + size * Vec3(0, 0.9, 2.4), box.center(), Vec3::UnitY(), 0.95 * size};
        const Image image = supersampled(
            view, tile, tile, samples,
            [&](const Ray& ray) {
                const auto hit = body.surface.intersect(ray);
                return hit ? litColor(*hit, -ray.direction, Vec3::UnitY(), body.color) : paperColor();
            },
            context.threads());
        drawing.image(image, {Vec2(x, top), Vec2(x + tile, top + tile)});
        drawing.text({x + tile / 2.0, 32}, body.name, {.size = 19, .horizontal = HorizontalAnchor::Centre});
        context.progress().advance();
        x += tile + gap;
    }
    drawing.save(context.output("bodies.png"));
}

}  // namespace caustic
