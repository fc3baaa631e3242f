#include <memory>
#include <string>

#include "camera/thin_lens_camera.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "light/constant_environment.h"
#include "material/diffuse_material.h"
#include "modeler/objects.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/checker_texture.h"

namespace caustic {

namespace {

SceneObject ball(const Vec3& center, Real radius, const Color& reflectance) {
    return {std::make_shared<Sphere>(center, radius), std::make_shared<DiffuseMaterial>(reflectance)};
}

// Two rows of balls that lead away from the camera, and a lamp above.
SceneDescription ballsScene(Real lensRadius, int width, int height) {
    SceneDescription scene;
    const auto board = std::make_shared<CheckerTexture>(Color(0.62, 0.58, 0.5), Color(0.2, 0.2, 0.22), 1.0 / 12);
    scene.objects.push_back({std::make_shared<Rectangle>(Vec3(-6, 0, 6), Vec3(12, 0, 0), Vec3(0, 0, -12)),
                             std::make_shared<DiffuseMaterial>(board)});
    const Color colors[] = {
        {0.7, 0.15, 0.1}, {0.75, 0.5, 0.08}, {0.25, 0.55, 0.2}, {0.12, 0.4, 0.65}, {0.45, 0.2, 0.5}};
    for (int i = 0; i < 5; ++i) {
        scene.objects.push_back(ball({-1.3 + 0.35 * i, 0.4, 2.4 - 1.5 * i}, 0.4, colors[i]));
        scene.objects.push_back(i % 2 == 0 ? glassBall({0.4 + 0.55 * i, 0.301, 1.6 - 1.5 * i}, 0.3, 1.5)
                                           : mirrorBall({0.4 + 0.55 * i, 0.3, 1.6 - 1.5 * i}, 0.3));
    }
    scene.objects.push_back(rectangleLamp({-1, 6, 1}, {3, 0, 0}, {0, 0, 3}, Color(9, 8.4, 7.5)));
    scene.lights = {std::make_shared<ConstantEnvironment>(Color(0.35, 0.42, 0.55))};
    const Vec3 eye(0, 1.5, 6.5);
    scene.camera = std::make_shared<ThinLensCamera>(eye, Vec3(0.1, 0.3, -0.6), Vec3::UnitY(), 0.5, width, height,
                                                    lensRadius, (Vec3(-0.6, 0.4, -0.6) - eye).norm());
    return scene;
}

}  // namespace

void drawDepthOfField(FigureContext& context) {
    const auto tile = [&](const std::string& caption, Real radius) {
        return Tile{caption, [&context, radius](int width, int height) {
                        return tracedPicture(Scene(ballsScene(radius, width, height)), context.byQuality(2, 144), {},
                                             context);
                    }};
    };
    drawTiles({tile("a pinhole", 0), tile("lens of radius 4 cm", 0.04), tile("lens of radius 16 cm", 0.16)}, 480, 360,
              "depth_of_field.png", context);
}

}  // namespace caustic
