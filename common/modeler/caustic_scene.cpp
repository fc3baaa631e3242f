#include "modeler/caustic_scene.h"

#include <cmath>
#include <numbers>

#include "camera/pinhole_camera.h"
#include "material/mirror_material.h"
#include "modeler/objects.h"
#include "shape/rectangle.h"

namespace caustic {

namespace {

SceneDescription lampBallFloor(const CausticScene& one) {
    const Vec3 half(one.lampSide / 2, one.lampSide / 2, 0);
    SceneDescription scene;
    scene.objects = {
        diffuseRectangle({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}, Color::Constant(one.floor)),
        glassBall(one.ball, one.radius, one.ior),
        rectangleLamp(one.lamp - half, {0, one.lampSide, 0}, {one.lampSide, 0, 0}, Color::Constant(one.radiance()))};
    return scene;
}

}  // namespace

Real CausticScene::radiance() const { return power / (std::numbers::pi * lampSide * lampSide); }

SceneDescription CausticScene::onFloor(int width) const {
    SceneDescription scene = lampBallFloor(*this);
    const Vec3 middle(0.3, 0, 0);
    scene.camera = std::make_shared<PinholeCamera>(middle + Vec3::UnitZ(), middle, Vec3::UnitY(), 2 * std::atan(shown),
                                                   width, width);
    return scene;
}

SceneDescription CausticScene::beforeMirror(int width, int height) const {
    SceneDescription scene = lampBallFloor(*this);
    scene.objects.push_back(
        {.shape = std::make_shared<Rectangle>(Vec3(-1.7, 1.1, 0.05), Vec3(2.9, 0, 0), Vec3(0, 0, 1.6)),
         .material = std::make_shared<MirrorMaterial>(Color::Constant(0.9))});
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.4, -4.2, 2.2), Vec3(-0.35, 0.1, 0.62), Vec3::UnitZ(), 0.55,
                                                   width, height);
    return scene;
}

}  // namespace caustic
