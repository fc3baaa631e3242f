#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "core/progress.h"
#include "figures.h"
#include "figures/lit_color.h"
#include "image/color_space.h"
#include "image/drawing.h"
#include "image/ray_view.h"
#include "patch_file.h"
#include "shape/group.h"
#include "shape/instance.h"
#include "surface/patch_surface.h"

namespace caustic {

namespace {

// Each patch an instance that names it, so that a hit tells which one it is on.
Group groupOf(const std::vector<NamedPatch>& patches) {
    std::vector<std::shared_ptr<const Shape>> members;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        members.push_back(std::make_shared<Instance>(std::make_shared<PatchSurface>(patches[i].patch), Transform(),
                                                     static_cast<ObjectId>(i)));
    }
    return Group(std::move(members));
}

Color partColor(const std::string& part, const Hit& hit) {
    const std::map<std::string, Color> colors = {{"rim", {0.65, 0.42, 0.1}},   {"body", {0.08, 0.3, 0.62}},
                                                 {"handle", {0.1, 0.5, 0.35}}, {"spout", {0.7, 0.28, 0.1}},
                                                 {"lid", {0.5, 0.3, 0.5}},     {"bottom", {0.4, 0.4, 0.4}}};
    const auto found = colors.find(part);
    const Color color = found == colors.end() ? Color(0.5, 0.5, 0.5) : found->second;
    const Vec2 squares = 6 * hit.uv;
    const bool dark = std::fmod(std::floor(squares.x()) + std::floor(squares.y()), 2) != 0;
    return color * (dark ? 0.75 : 1.15);
}

}  // namespace

void drawTeapot(FigureContext& context) {
    constexpr int width = 800;
    constexpr int height = 560;
    const auto patches = loadPatches(context.asset("assets/teapot/teapot.txt"));
    const Group group = groupOf(patches);
    const RayView view = {Vec3(-4, -11, 6.2), Vec3(0.2, 0, 1.45), Vec3::UnitZ(), 4.7};
    const int samples = context.byQuality(1, 4);
    context.progress().expect(2);
    Drawing drawing(2 * width + 12, height + 50);
    for (const bool byPart : {true, false}) {
        const Image image = supersampled(
            view, width, height, samples,
            [&](const Ray& ray) -> Color {
                const auto hit = group.intersect(ray);
                if (!hit) return paperColor();
                if (!byPart) return srgbDecode(Color((hit->ns.array() + 1) / 2));
                const Color color = partColor(patches[static_cast<std::size_t>(hit->object)].name, *hit);
                return litColor(*hit, -ray.direction, Vec3::UnitZ(), color);
            },
            context.threads());
        const Vec2 corner(byPart ? 0 : width + 12, 50);
        drawing.image(image, {corner, corner + Vec2(width, height)});
        drawing.text(corner + Vec2(width / 2.0, -18),
                     byPart ? "32 bicubic patches, six squares each way" : "normals, (x, y, z) as (red, green, blue)",
                     {.size = 20, .horizontal = HorizontalAnchor::Centre});
        context.progress().advance();
    }
    drawing.save(context.output("teapot.png"));
}

}  // namespace caustic
