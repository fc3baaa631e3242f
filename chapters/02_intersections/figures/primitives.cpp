#include <array>
#include <memory>
#include <string>

#include "core/progress.h"
#include "figures.h"
#include "figures/shape_view.h"
#include "image/drawing.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "shape_catalogue.h"

namespace caustic {

namespace {

struct Exhibit {
    std::string name;
    std::shared_ptr<const Shape> shape;
    Vec2 squares;  // of the checkerboard in u and v
};

std::array<Exhibit, 6> exhibits() {
    const auto sphere = std::make_shared<Sphere>(Vec3::Zero(), 1.15);
    return {{
        {"box", std::make_shared<Box>(Vec3(-0.9, -0.7, -0.8), Vec3(0.9, 0.7, 0.8)), {6, 6}},
        {"sphere", sphere, {16, 8}},
        {"plane", std::make_shared<Plane>(Vec3(0, -0.6, 0), Vec3::UnitY()), {2, 2}},
        {"triangle", std::make_shared<Triangle>(Vec3(-1.2, -0.9, 0.4), Vec3(1.3, -0.6, 0), Vec3(0, 1.2, -0.3)), {8, 8}},
        {"ring cylinder", std::make_shared<RingCylinder>(0.6, 1.1, -0.6, 0.6), {16, 20}},
        {"mirrored, sheared instance",
         std::make_shared<Instance>(sphere, unevenTransform(true) * Transform::scaling(Vec3::Constant(0.62))),
         {16, 8}},
    }};
}

}  // namespace

void drawPrimitives(FigureContext& context) {
    constexpr int tile = 260;
    constexpr int gap = 16;
    constexpr int left = 130;
    constexpr int top = 60;
    const auto shapes = exhibits();
    const int samples = context.byQuality(3, 6);
    const RayView view = {Vec3(3.2, 2.6, 5.2), Vec3::Zero(), Vec3::UnitY(), 3.1, false};
    const int columns = static_cast<int>(shapes.size());
    Drawing drawing(left + columns * (tile + gap), top + 2 * (tile + gap));
    context.progress().expect(2 * columns);
    for (int column = 0; column < columns; ++column) {
        const Exhibit& exhibit = shapes[static_cast<std::size_t>(column)];
        const Real x = left + column * (tile + gap);
        drawing.text({x + tile / 2.0, top - 20.0}, exhibit.name, {.size = 19, .horizontal = HorizontalAnchor::Centre});
        for (int row = 0; row < 2; ++row) {
            const HitColor color = row == 0 ? HitColor(normalColor) : uvColor(exhibit.squares);
            const Image image = drawShape(*exhibit.shape, view, tile, tile, samples, color, context.threads());
            const Vec2 corner(x, top + row * (tile + gap));
            drawing.image(image, {corner, corner + Vec2(tile, tile)});
            context.progress().advance();
        }
    }
    const std::array<std::array<std::string, 2>, 2> rows = {{{"normal", "(x, y, z)"}, {"u and v", "(red, green)"}}};
    for (int row = 0; row < 2; ++row) {
        const Real y = top + row * (tile + gap) + tile / 2.0;
        drawing.text({18, y - 12}, rows[static_cast<std::size_t>(row)][0], {.size = 19});
        drawing.text({18, y + 14}, rows[static_cast<std::size_t>(row)][1], {.size = 14});
    }
    drawing.save(context.output("primitives.png"));
}

}  // namespace caustic
