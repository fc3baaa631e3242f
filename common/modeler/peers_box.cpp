#include "modeler/peers_box.h"

#include <numbers>

#include "camera/pinhole_camera.h"
#include "modeler/objects.h"

namespace caustic {

namespace {

const Color white = Color::Constant(0.803922);
const Color green(0.156863, 0.803922, 0.172549);
const Color red(0.803922, 0.152941, 0.152941);

void addWalls(SceneDescription& scene) {
    const Vec3 low(-1.27029, -1.25549, -1.28002);
    const Vec3 size(2.56004, 2.56004, 2.56004);
    const Vec3 x(size.x(), 0, 0);
    const Vec3 y(0, size.y(), 0);
    const Vec3 z(0, 0, size.z());
    scene.objects.push_back(diffuseRectangle(low, x, y, white));      // floor
    scene.objects.push_back(diffuseRectangle(low + z, x, y, white));  // ceiling
    scene.objects.push_back(diffuseRectangle(low + y, x, z, white));  // back
    scene.objects.push_back(diffuseRectangle(low, y, z, green));      // left
    scene.objects.push_back(diffuseRectangle(low + x, y, z, red));    // right
}

// A white box against the ceiling whose lower face shines.
void addLamp(SceneDescription& scene) {
    const Vec3 low(-0.25, -0.25, 1.26002);
    const Vec3 x(0.5, 0, 0);
    const Vec3 y(0, 0.5, 0);
    const Vec3 z(0, 0, 0.02);
    scene.objects.push_back(rectangleLamp(low, y, x, Color::Constant(25.0333)));
    scene.objects.push_back(diffuseRectangle(low, x, z, white));
    scene.objects.push_back(diffuseRectangle(low + y, x, z, white));
    scene.objects.push_back(diffuseRectangle(low, y, z, white));
    scene.objects.push_back(diffuseRectangle(low + x, y, z, white));
}

}  // namespace

SceneDescription peersBox(int width, int height) {
    SceneDescription scene;
    addWalls(scene);
    addLamp(scene);
    scene.objects.push_back(mirrorBall({-0.53885, 0.02453, -0.78002}, 0.5));
    scene.objects.push_back(glassBall({0.55831, 0.02453, -0.78002}, 0.5, 1.6));
    const Vec3 eye(-0.0439815, -4.12529, 0.222539);
    const Vec3 forward(0.00688625, 0.998505, -0.0542161);
    const Vec3 up(0.000373896, 0.0542148, 0.998529);
    scene.camera = std::make_shared<PinholeCamera>(eye, eye + forward, up, std::numbers::pi / 4, width, height);
    return scene;
}

}  // namespace caustic
