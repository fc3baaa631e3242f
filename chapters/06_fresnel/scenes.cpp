#include "scenes.h"

#include <numbers>
#include <utility>

#include "camera/pinhole_camera.h"
#include "light/constant_environment.h"
#include "material/diffuse_material.h"
#include "modeler/objects.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/checker_texture.h"

namespace caustic {

namespace {

const Interior glassInside = {1.5, nullptr, 0};

// Squares of one unit on y = 0, around the origin.
SceneObject checkeredFloor(Real size) {
    const auto board = std::make_shared<CheckerTexture>(Color(0.72, 0.7, 0.65), Color(0.2, 0.2, 0.22), 1 / size);
    return {.shape = std::make_shared<Rectangle>(Vec3(-size / 2, 0, size / 2), Vec3(size, 0, 0), Vec3(0, 0, -size)),
            .material = std::make_shared<DiffuseMaterial>(board)};
}

}  // namespace

SceneDescription glassScene(std::shared_ptr<const Material> glass, int width, int height) {
    const auto turned = [](const Vec3& place, Real radians) {
        return Transform::translation(place) * Transform::rotation(Vec3::UnitY(), radians);
    };
    const auto block = std::make_shared<Box>(Vec3(-0.8, 0, -0.5), Vec3(0.8, 1.5, 0.5));
    const Vec3 bubble(2.1, 1.0, 0.5);
    SceneDescription scene;
    scene.objects = {
        checkeredFloor(16),
        diffuseRectangle({-6, 0, -5}, {12, 0, 0}, {0, 7, 0}, Color(0.75, 0.73, 0.7)),
        diffuseRectangle({-6, 0, 8}, {0, 0, -13}, {0, 7, 0}, Color(0.2, 0.42, 0.6)),
        diffuseRectangle({6, 0, -5}, {0, 0, 13}, {0, 7, 0}, Color(0.66, 0.33, 0.17)),
        rectangleLamp({-2.5, 6.9, -2}, {5, 0, 0}, {0, 0, 4}, Color(7, 6.8, 6.4)),
        rectangleLamp({-4.5, 1.5, 7.9}, {0, 4, 0}, {3, 0, 0}, Color(3, 3.1, 3.4)),
        {.shape = std::make_shared<Instance>(block, turned({-2.3, 1e-3, 0.2}, 0.5)),
         .material = glass,
         .interior = glassInside},
        {.shape = std::make_shared<Sphere>(Vec3(0, 1.101, -0.8), 1.1), .material = glass, .interior = glassInside},
        {.shape = std::make_shared<Sphere>(bubble, 0.999), .material = glass, .interior = glassInside},
        {.shape = std::make_shared<Sphere>(bubble, 0.93),
         .material = std::move(glass),
         .interior = Interior{1, nullptr, 1}},
    };
    scene.ambient = Color(0.2, 0.2, 0.22);
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0, 3.2, 7.6), Vec3(0, 1.0, 0), Vec3::UnitY(), 0.6, width, height);
    return scene;
}

SceneDescription ballScene(std::shared_ptr<const Material> material, bool glass, int width, int height) {
    SceneDescription scene;
    scene.objects = {
        checkeredFloor(16),
        rectangleLamp({-4, 1.2, 4.2}, {1.6, 0, -3.2}, {0, 3.6, 0}, Color(4.2, 4.1, 3.9)),
        rectangleLamp({2.6, 0.8, -1.4}, {0.4, 0, 3}, {0, 3.4, 0}, Color(2.4, 2.5, 2.7)),
        {.shape = std::make_shared<Sphere>(Vec3(0, 1.001, 0), 1.0), .material = std::move(material)},
    };
    if (glass) scene.objects.back().interior = glassInside;
    scene.lights = {std::make_shared<ConstantEnvironment>(Color(0.5, 0.49, 0.47))};
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0, 2.3, 5.2), Vec3(0, 0.95, 0), Vec3::UnitY(), 0.46, width, height);
    return scene;
}

SceneDescription paneScene(std::shared_ptr<const Material> glass, Real ior) {
    SceneDescription scene;
    scene.objects = {{.shape = std::make_shared<Box>(Vec3(0, -9, -9), Vec3(1, 9, 9)),
                      .material = std::move(glass),
                      .interior = Interior{ior, nullptr, 0}},
                     rectangleLamp({3, -9, -9}, {0, 0, 18}, {0, 18, 0}, Color::Ones())};  // faces −x
    return scene;
}

}  // namespace caustic
