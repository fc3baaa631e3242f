#include <array>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/progress.h"
#include "figures.h"
#include "figures/shape_view.h"
#include "image/color_space.h"
#include "image/drawing.h"
#include "shape/box.h"
#include "shape/group.h"
#include "shape/instance.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"

namespace caustic {

namespace {

using ShapePointer = std::shared_ptr<const Shape>;

ShapePointer placed(const ShapePointer& shape, const Transform& transform, ObjectId object = noObject) {
    return std::make_shared<Instance>(shape, transform, object);
}

ShapePointer group(std::vector<ShapePointer> members) { return std::make_shared<Group>(std::move(members)); }

Transform moved(Real x, Real y, Real z) { return Transform::translation({x, y, z}); }
Transform stretched(Real x, Real y, Real z) { return Transform::scaling({x, y, z}); }
Transform turnedY(Real turns) { return Transform::rotation(Vec3::UnitY(), 2 * std::numbers::pi * turns); }

// A gondola that hangs from the origin: a rod, a bowl, a seat and two passengers who share one head.
ShapePointer gondola() {
    const auto rod = std::make_shared<RingCylinder>(0, 0.025, -0.75, 0);
    const auto bowl = std::make_shared<RingCylinder>(0.3, 0.36, -0.95, -0.7);
    const auto floor = std::make_shared<RingCylinder>(0, 0.36, -1, -0.95);
    const auto head = std::make_shared<Sphere>(Vec3::Zero(), 0.1);
    const auto body = std::make_shared<Box>(Vec3(-0.09, -0.32, -0.07), Vec3(0.09, -0.1, 0.07));
    const auto passenger = group({head, body});
    return group({rod, bowl, floor, placed(passenger, moved(-0.15, -0.58, 0) * turnedY(0.06)),
                  placed(passenger, moved(0.15, -0.6, 0) * turnedY(-0.1) * stretched(0.9, 0.9, 0.9))});
}

// A wheel of gondolas: spokes are one stretched box, gondolas lean outwards as it turns. Objects are numbered 1, 2...
ShapePointer wheel(int gondolas, const ShapePointer& hanging, ObjectId first) {
    const auto beam = std::make_shared<Box>(Vec3(0, -0.03, -0.05), Vec3(1, 0.03, 0.05));
    std::vector<ShapePointer> members = {std::make_shared<RingCylinder>(0.98, 1.06, -0.04, 0.04),
                                         std::make_shared<RingCylinder>(0, 0.16, -0.12, 0.14)};
    for (int i = 0; i < gondolas; ++i) {
        const Transform turn = turnedY(Real(i) / gondolas);
        const Transform lean =
            moved(1.02, -0.04, 0) * Transform::rotation(Vec3::UnitZ(), 0.35) * stretched(0.7, 0.7, 0.7);
        members.push_back(placed(beam, turn));
        members.push_back(placed(hanging, turn * lean, first + i));
    }
    return group(members);
}

// Level 0 a sphere, level n a sphere with nine of level n - 1 around it: each level is one group, shared by nine
// instances, so level 4 shows 7381 spheres and keeps one.
ShapePointer sphereFlake(int level) {
    const auto sphere = std::make_shared<Sphere>(Vec3::Zero(), 1.0);
    if (level == 0) return sphere;
    const ShapePointer smaller = sphereFlake(level - 1);
    std::vector<ShapePointer> members = {sphere};
    for (int i = 0; i < 9; ++i) {
        const bool low = i < 6;
        const Transform turn = turnedY(low ? i / 6.0 : i / 3.0 + 1 / 12.0);
        const Transform tilt = Transform::rotation(Vec3::UnitZ(), low ? -std::numbers::pi / 2 : -0.6);
        members.push_back(placed(smaller, turn * tilt * moved(0, 4.0 / 3, 0) * stretched(1 / 3.0, 1 / 3.0, 1 / 3.0)));
    }
    return group(members);
}

// A hue for each object, white for what has no name.
Color objectColor(const Hit& hit, const Vec3& wo) {
    const Color hue = hit.object == noObject ? Color(0.85, 0.85, 0.83) : hsvToRgb(0.117 * hit.object, 0.55, 0.92);
    return srgbDecode(hue) * (0.3 + 0.7 * std::abs(hit.ns.dot(wo)));
}

}  // namespace

void drawHierarchy(FigureContext& context) {
    constexpr int side = 620;
    constexpr int top = 50;
    const ShapePointer hanging = gondola();
    const auto post = std::make_shared<RingCylinder>(0, 0.07, -1.35, 1.15);
    const auto small = placed(wheel(5, hanging, 20), moved(0, 0.95, 0) * turnedY(0.07) * stretched(0.55, 0.55, 0.55));
    const auto large = placed(wheel(8, hanging, 1), Transform());
    const auto foot = std::make_shared<RingCylinder>(0.5, 0.9, -1.45, -1.35);
    const ShapePointer carousel = group({post, foot, large, small});
    const int samples = context.byQuality(2, 6);
    context.progress().expect(2);

    Drawing drawing(2 * side + 20, side + top);
    const auto show = [&](int column, const Shape& shape, const RayView& view, const HitColor& color,
                          const std::string& title) {
        const Vec2 corner(column * (side + 20), top);
        const Image image = drawShape(shape, view, side, side, samples, color, context.threads());
        drawing.image(image, {corner, corner + Vec2(side, side)});
        drawing.text(corner + Vec2(side / 2.0, -18), title, {.size = 19, .horizontal = HorizontalAnchor::Centre});
        context.progress().advance();
    };
    show(0, *carousel, {Vec3(2.6, 2.3, 4.6), Vec3(0, -0.15, 0), Vec3::UnitY(), 3.3, false}, objectColor,
         "Groups in groups: one gondola, seen 13 times; colour: object");
    const ShapePointer flake = sphereFlake(context.byQuality(3, 4));
    show(1, *flake, {Vec3(3, 2.4, 4), Vec3(0, 0.1, 0), Vec3::UnitY(), 4.1, false}, normalColor,
         "Each level holds the level below nine times; colour: normal");
    drawing.save(context.output("hierarchy.png"));
}

}  // namespace caustic
