#include <memory>

#include "camera/pinhole_camera.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "light/constant_environment.h"
#include "light/weighted_shape.h"
#include "material/diffuse_material.h"
#include "modeler/objects.h"
#include "patterns.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"
#include "texture/image_texture.h"

namespace caustic {

namespace {

// A small picture to see pixels of.
std::shared_ptr<const Image> motif() {
    Image image(12, 12, Color(0.75, 0.7, 0.6));
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            const int d = std::abs(2 * x - 11) + std::abs(2 * y - 11);
            if (d <= 10) image.set(x, y, Color(0.55, 0.1, 0.06));
            if (d <= 5) image.set(x, y, Color(0.05, 0.2, 0.45));
            if (x == 0 || y == 0) image.set(x, y, Color(0.1, 0.25, 0.12));
        }
    }
    return std::make_shared<const Image>(std::move(image));
}

// A board and a ball with a picture on both, under an even sky and a lamp.
SceneDescription ballOnBoard(const std::shared_ptr<const Texture>& board, const std::shared_ptr<const Texture>& onBall,
                             int width, int height) {
    SceneDescription scene;
    scene.objects = {{std::make_shared<Rectangle>(Vec3(-2, 0, 2), Vec3(4, 0, 0), Vec3(0, 0, -4)),
                      std::make_shared<DiffuseMaterial>(board)},
                     {std::make_shared<Sphere>(Vec3(0.1, 0.801, 0), 0.8), std::make_shared<DiffuseMaterial>(onBall)},
                     rectangleLamp({-3, 4, 1}, {1.5, 0, 0}, {0, 0, 1.5}, Color(14, 13, 11))};
    scene.lights = {std::make_shared<ConstantEnvironment>(Color(0.3, 0.35, 0.42))};
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0.4, 2.1, 4.2), Vec3(0, 0.55, 0), Vec3::UnitY(), 0.55, width, height);
    return scene;
}

// A window that lights a dark room: wall, floor and a ball.
SceneDescription windowRoom(bool byBrightness, int width, int height) {
    Image image = windowPattern(48, 72);
    for (float& value : image.data()) value *= 12;
    // One pane has the evening sun.
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 24; ++x) image.set(x, y, 12.0 * Color(image.at(x, y) * Color(3.2, 1.6, 0.5) / 12));
    }
    std::shared_ptr<const Shape> pane =
        std::make_shared<Rectangle>(Vec3(-1.9, 0.5, 0.8), Vec3(0, 0, -1.2), Vec3(0, 1.7, 0));
    if (byBrightness) pane = std::make_shared<WeightedShape>(pane, image, Wrap::Clamp);
    SceneDescription scene;
    scene.objects = {
        diffuseRectangle({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, Color(0.6, 0.5, 0.4)),
        diffuseRectangle({-2, 0, -1.5}, {4, 0, 0}, {0, 3, 0}, Color(0.7, 0.7, 0.68)),
        {std::make_shared<Sphere>(Vec3(0.4, 0.601, -0.3), 0.6),
         std::make_shared<DiffuseMaterial>(Color(0.7, 0.7, 0.72))},
        {std::make_shared<Sphere>(Vec3(-0.7, 0.301, 0.5), 0.3),
         std::make_shared<DiffuseMaterial>(Color(0.65, 0.2, 0.1))},
        {pane, nullptr, std::nullopt,
         std::make_shared<ImageTexture>(std::make_shared<const Image>(image), Lookup::Bilinear, Wrap::Clamp)}};
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(1.0, 1.6, 5.2), Vec3(-0.45, 0.8, -0.3), Vec3::UnitY(), 0.5, width, height);
    return scene;
}

}  // namespace

void drawTextures(FigureContext& context) {
    const std::int64_t paths = context.byQuality(2, 64);
    const auto textured = [&](const std::string& caption, Lookup lookup) {
        return Tile{caption, [&context, lookup, paths](int width, int height) {
                        const auto board = std::make_shared<ImageTexture>(motif(), lookup, Wrap::Repeat, Vec2(4, 4));
                        const auto onBall = std::make_shared<ImageTexture>(motif(), lookup, Wrap::Repeat, Vec2(4, 2));
                        return tracedPicture(Scene(ballOnBoard(board, onBall, width, height)), paths, {}, context);
                    }};
    };
    const Tile lamp = {"a lamp that shines as an image", [&](int width, int height) {
                           return tracedPicture(Scene(windowRoom(true, width, height)), paths, {.exposure = 0.5},
                                                context);
                       }};
    drawTiles({textured("nearest pixel", Lookup::Nearest), textured("bilinear", Lookup::Bilinear), lamp}, 420, 340,
              "textures.png", context);
}

}  // namespace caustic
