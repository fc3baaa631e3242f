#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "light/cone_light.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "scenes.h"
#include "shape/rectangle.h"
#include "texture/constant_texture.h"

namespace caustic {

namespace {

SceneDescription litRoom(int width, int height) {
    SceneDescription scene = emptyRoom();
    scene.objects.push_back(ballOnFloor(std::make_shared<DiffuseMaterial>(Color(0.75, 0.6, 0.25))));
    scene.ambient = Color::Constant(0.12);
    scene.camera = roomCamera(width, height);
    return scene;
}

const Vec3 lampPlace(-1.1, 3.6, 1.4);

}  // namespace

void drawShadows(FigureContext& context) {
    const auto take = [&](const SceneDescription& scene) {
        return takePicture(scene, {context.byQuality(2, 5), {.maxDepth = 2, .shadowSamples = 4}}, context);
    };
    const Tile point = {"point", [&](int width, int height) {
                            SceneDescription scene = litRoom(width, height);
                            scene.lights = {std::make_shared<PointLight>(lampPlace, Color::Constant(14))};
                            return take(scene);
                        }};
    const Tile cone = {
        "cone", [&](int width, int height) {
            SceneDescription scene = litRoom(width, height);
            scene.lights = {std::make_shared<ConeLight>(lampPlace, Vec3(0.9, -2.8, -1.1), 0.42, Color::Constant(20))};
            return take(scene);
        }};
    const Tile rectangle = {"rectangle", [&](int width, int height) {
                                SceneDescription scene = litRoom(width, height);
                                SceneObject lamp;
                                lamp.shape = std::make_shared<Rectangle>(lampPlace - Vec3(0.6, 0, 0.6), Vec3(1.2, 0, 0),
                                                                         Vec3(0, 0, 1.2));
                                lamp.emission = std::make_shared<ConstantTexture>(Color::Constant(11));
                                scene.objects.push_back(lamp);
                                return take(scene);
                            }};
    drawTiles({point, cone, rectangle}, 420, 380, "shadows.png", context);
}

}  // namespace caustic
