#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "core/progress.h"
#include "figures.h"
#include "figures/mesh_view.h"
#include "image/color_space.h"
#include "image/drawing.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_tree.h"
#include "mesh_sets.h"

namespace caustic {

namespace {

constexpr int tile = 380;
constexpr int gap = 14;
constexpr int top = 60;
constexpr int scaleHeight = 70;
constexpr Real most = 300;

// From dark blue through red and yellow to white, brighter all the way: by steps looked at.
Color heat(Real value) {
    const Real x = std::clamp(std::log1p(value) / std::log1p(most), Real(0), Real(1));
    const Real hue = 0.66 - 0.66 * std::min(Real(1), 1.3 * x);
    const Real white = std::clamp((x - 0.75) / 0.25, Real(0), Real(1));
    const Color pure = srgbDecode(hsvToRgb(hue, 1, 0.25 + 0.75 * std::min(Real(1), 1.5 * x)));
    return pure + white * (Color::Ones() - pure);
}

void drawScale(Drawing& drawing, Real left, Real y) {
    constexpr int width = 700;
    Image strip(width, 1);
    for (int i = 0; i < width; ++i) strip.set(i, 0, heat(std::expm1(std::log1p(most) * (i + 0.5) / width)));
    drawing.image(strip, {Vec2(left, y), Vec2(left + width, y + 18)});
    for (const int value : {0, 1, 3, 10, 30, 100, 300}) {
        const std::string label = std::to_string(value) + (value == most ? " or more" : "");
        drawing.text({left + width * std::log1p(value) / std::log1p(most), y + 40}, label,
                     {.size = 16, .horizontal = HorizontalAnchor::Centre});
    }
    drawing.text({left - 12, y + 15}, "nodes + tests", {.size = 16, .horizontal = HorizontalAnchor::Right});
}

}  // namespace

void drawHeatMap(FigureContext& context) {
    const auto mesh = std::make_shared<const MeshData>(loadMesh(context.asset("assets/meshes/dragon.ply")));
    constexpr std::array kinds = {MeshTreeKind::MedianKdTree, MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree,
                                  MeshTreeKind::WideBvh};
    RayView view = viewOf(boundsOf(*mesh), Vec3(0.1, 0.25, 1));
    view.height *= 1.2;
    Drawing drawing(4 * (tile + gap) + gap, top + tile + scaleHeight);
    context.progress().expect(4);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto tree = plantMeshTree(kinds[i], mesh);
        Image image(tile, tile);
        Real sum = 0;
        for (int y = 0; y < tile; ++y) {
            for (int x = 0; x < tile; ++x) {
                MeshWork work;
                tree->intersectCounted(rayThrough(view, Vec2((x + 0.5) / tile, (y + 0.5) / tile), 1), work);
                const auto steps = static_cast<Real>(work.nodes + work.tests);
                sum += steps;
                image.set(x, y, heat(steps));
            }
        }
        const Real left = gap + static_cast<Real>(i) * (tile + gap);
        drawing.image(image, {Vec2(left, top), Vec2(left + tile, top + tile)});
        std::string mean = std::to_string(std::lround(10 * sum / (tile * tile)));
        mean.insert(mean.size() - 1, ".");
        drawing.text({left + tile / 2.0, top - 34.0}, name(kinds[i]),
                     {.size = 21, .horizontal = HorizontalAnchor::Centre});
        drawing.text({left + tile / 2.0, top - 11.0}, mean + " a ray on average",
                     {.size = 16, .horizontal = HorizontalAnchor::Centre});
        context.progress().advance();
    }
    drawScale(drawing, 420, top + tile + 12);
    drawing.save(context.output("heat_map.png"));
}

}  // namespace caustic
