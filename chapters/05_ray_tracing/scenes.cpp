#include "scenes.h"

#include <utility>

#include "camera/pinhole_camera.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/checker_texture.h"
#include "texture/constant_texture.h"

namespace caustic {

namespace {

SceneObject wall(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV, const Color& reflectance) {
    return {.shape = std::make_shared<Rectangle>(corner, edgeU, edgeV),
            .material = std::make_shared<DiffuseMaterial>(reflectance)};
}

}  // namespace

std::shared_ptr<const Material> clearGlass() {
    return std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones());
}

Interior glassOf(const Color& perUnit) {
    return {1.5, std::make_shared<AbsorbingMedium>(AbsorbingMedium::ofTransmittance(perUnit)), 0};
}

SceneDescription emptyRoom() {
    const Color white = Color::Constant(0.75);
    const auto board = std::make_shared<CheckerTexture>(Color(0.75, 0.72, 0.66), Color(0.32, 0.3, 0.28), 0.1);
    SceneDescription room;
    room.objects = {
        {.shape = std::make_shared<Rectangle>(Vec3(-2.5, 0, 7), Vec3(5, 0, 0), Vec3(0, 0, -9.5)),
         .material = std::make_shared<DiffuseMaterial>(board)},
        wall({-2.5, 4, -2.5}, {5, 0, 0}, {0, 0, 9.5}, white),
        wall({-2.5, 0, -2.5}, {5, 0, 0}, {0, 4, 0}, white),
        wall({2.5, 0, 7}, {-5, 0, 0}, {0, 4, 0}, white),
        wall({-2.5, 0, 7}, {0, 0, -9.5}, {0, 4, 0}, Color(0.22, 0.45, 0.62)),
        wall({2.5, 0, -2.5}, {0, 0, 9.5}, {0, 4, 0}, Color(0.7, 0.35, 0.18)),
    };
    return room;
}

void addLamp(SceneDescription& scene) {
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-0.8, 3.98, -0.6), Vec3(1.6, 0, 0), Vec3(0, 0, 1.6));
    lamp.emission = std::make_shared<ConstantTexture>(Color(9, 8.6, 7.8));
    scene.objects.push_back(lamp);
    scene.ambient = Color(0.22, 0.23, 0.26);
}

std::shared_ptr<const Camera> roomCamera(int width, int height) {
    return std::make_shared<PinholeCamera>(Vec3(0, 1.9, 6.8), Vec3(0, 1.35, 0), Vec3::UnitY(), 0.62, width, height);
}

SceneObject ballOnFloor(std::shared_ptr<const Material> material) {
    return {.shape = std::make_shared<Sphere>(Vec3(0, 1, 0.3), 1.0), .material = std::move(material)};
}

SceneDescription boxScene(int width, int height) {
    SceneDescription scene = emptyRoom();
    addLamp(scene);
    scene.objects.push_back({.shape = std::make_shared<Sphere>(Vec3(-1.05, 0.95, -0.7), 0.95),
                             .material = std::make_shared<MirrorMaterial>(Color::Constant(0.92))});
    scene.objects.push_back({.shape = std::make_shared<Sphere>(Vec3(1.0, 0.85, 0.9), 0.85),
                             .material = clearGlass(),
                             .interior = glassOf(Color(0.92, 0.97, 0.95))});
    scene.camera = roomCamera(width, height);
    return scene;
}

SceneDescription meshScene(const SceneObject& object, int width, int height) {
    const Bounds3 box = object.shape->bounds();
    const Real size = box.diagonal().norm() / 2;
    const Vec3 middle = box.center();
    const auto wall = [&](const Vec3& inSizes, const Vec3& normal, const Color& reflectance) {
        return SceneObject{.shape = std::make_shared<Plane>(middle + size * inSizes, normal),
                           .material = std::make_shared<DiffuseMaterial>(reflectance)};
    };
    const Real floor = (box.min().y() - middle.y()) / size - 1e-3;
    SceneDescription scene;
    // A room all around: what is behind the camera and beside it shows in a mirror.
    scene.objects = {object,
                     wall({0, floor, 0}, Vec3::UnitY(), Color::Constant(0.7)),
                     wall({0, 0, -6}, Vec3::UnitZ(), Color(0.62, 0.68, 0.75)),
                     wall({0, 0, 9}, -Vec3::UnitZ(), Color(0.75, 0.7, 0.62)),
                     wall({-7, 0, 0}, Vec3::UnitX(), Color(0.22, 0.45, 0.62)),
                     wall({7, 0, 0}, -Vec3::UnitX(), Color(0.7, 0.35, 0.18)),
                     wall({0, 6, 0}, -Vec3::UnitY(), Color::Constant(0.75))};
    SceneObject lamp;
    // U × V points down and towards the object.
    lamp.shape =
        std::make_shared<Rectangle>(middle + size * Vec3(-1.5, 4, 0), size * Vec3(3, 0, 0), size * Vec3(0, 0, 3));
    lamp.emission = std::make_shared<ConstantTexture>(Color::Constant(9));
    scene.objects.push_back(lamp);
    scene.ambient = Color::Constant(0.35);
    scene.camera = std::make_shared<PinholeCamera>(
        middle + size * Vec3(0.6, 1.1, 3.9), middle - size * Vec3(0, 0.12, 0), Vec3::UnitY(), 0.55, width, height);
    return scene;
}

}  // namespace caustic
