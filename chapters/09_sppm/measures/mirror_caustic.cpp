#include "measures/mirror_caustic.h"

#include <cmath>

#include "camera/pinhole_camera.h"
#include "core/check.h"
#include "material/mirror_material.h"
#include "modeler/caustic_scene.h"
#include "shape/rectangle.h"

namespace caustic {

namespace {

constexpr Real behind = 0.005;  // the mirror, below the camera of CausticScene::onFloor

}  // namespace

SceneDescription mirrorCaustic(int width) {
    SceneDescription scene = CausticScene{}.onFloor(width);
    // That camera is at height 1 and looks down; its image in the mirror is at 1 − 2 · behind and looks up.
    const Real height = 1 - behind;
    const Vec3 eye(0.3, 0, 1 - 2 * behind);
    const Real half = 1.2 * behind * CausticScene::shown;
    scene.objects.push_back(
        {std::make_shared<Rectangle>(Vec3(0.3 - half, -half, height), Vec3(0, 2 * half, 0), Vec3(2 * half, 0, 0)),
         std::make_shared<MirrorMaterial>(Color::Ones()),
         {},
         nullptr});
    scene.camera = std::make_shared<PinholeCamera>(eye, eye + Vec3::UnitZ(), Vec3::UnitY(),
                                                   2 * std::atan(CausticScene::shown), width, width);
    return scene;
}

SppmSettings mirrorCausticSettings() {
    SppmSettings settings;
    settings.limits.maxLength = 16;
    settings.radius = 0.03;
    return settings;
}

Image mirrorCausticReference(const Image& floor, int width) {
    checkArgument(width >= 1 && floor.width() % width == 0, "width", std::to_string(width),
                  "must divide the picture's " + std::to_string(floor.width()));
    const int block = floor.width() / width;
    Image reference(width, width);
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            Color sum = Color::Zero();
            for (int i = 0; i < block * block; ++i) sum += floor.at(x * block + i % block, y * block + i / block);
            reference.set(width - 1 - x, y, sum / (block * block));
        }
    }
    return reference;
}

}  // namespace caustic
