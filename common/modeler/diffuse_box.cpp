#include "modeler/diffuse_box.h"

#include "camera/pinhole_camera.h"
#include "material/mirror_material.h"
#include "modeler/objects.h"
#include "shape/rectangle.h"

namespace caustic {

namespace {

const Color white(0.75, 0.75, 0.75);
const Color red(0.65, 0.15, 0.12);
const Color blue(0.15, 0.25, 0.65);
const Vec3 x(2, 0, 0);
const Vec3 y(0, 2, 0);
const Vec3 z(0, 0, 2);

}  // namespace

std::vector<BoxWall> DiffuseBox::diffuseWalls() const {
    std::vector<BoxWall> walls = {
        {{-1, -1, -1}, x, y, white}, {{-1, -1, 1}, y, x, white}, {{-1, 1, -1}, x, z, white}, {{1, -1, -1}, z, y, blue}};
    if (!mirror) walls.push_back({{-1, -1, -1}, y, z, red});
    return walls;
}

BoxWall DiffuseBox::lamp() const {
    const Real half = lampSide / 2;
    return {{-half, -half, 1 - 1e-4}, {0, lampSide, 0}, {lampSide, 0, 0}, Color::Zero()};
}

SceneDescription DiffuseBox::scene(int width, int height) const {
    SceneDescription scene;
    for (const BoxWall& wall : diffuseWalls())
        scene.objects.push_back(diffuseRectangle(wall.corner, wall.edgeU, wall.edgeV, wall.reflectance));
    if (mirror) {
        scene.objects.push_back({.shape = std::make_shared<Rectangle>(Vec3(-1, -1, -1), y, z),
                                 .material = std::make_shared<MirrorMaterial>(Color::Constant(mirrored))});
    }
    const BoxWall shining = lamp();
    scene.objects.push_back(rectangleLamp(shining.corner, shining.edgeU, shining.edgeV, Color::Constant(radiance)));
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0, -3.2, 0), Vec3(0, 0, -0.42), Vec3::UnitZ(), 0.66, width, height);
    return scene;
}

}  // namespace caustic
