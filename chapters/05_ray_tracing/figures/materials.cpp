#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "scenes.h"
#include "texture/constant_texture.h"

namespace caustic {

void drawMaterials(FigureContext& context) {
    const auto paint = std::make_shared<ConstantTexture>(Color(0.65, 0.16, 0.1));
    const auto tile = [&](const std::string& caption, const std::shared_ptr<const Material>& material, bool glass) {
        return Tile{
            caption, [&context, material, glass](int width, int height) {
                SceneDescription scene = emptyRoom();
                addLamp(scene);
                scene.objects.push_back(ballOnFloor(material));
                if (glass) scene.objects.back().interior = glassOf(Color(0.92, 0.97, 0.95));
                scene.camera = roomCamera(width, height);
                return takePicture(scene, {context.byQuality(2, 5), {.maxDepth = 8, .shadowSamples = 2}}, context);
            }};
    };
    drawTiles({tile("diffuse, with Phong's highlight",
                    std::make_shared<PhongMaterial>(paint, Color::Constant(0.25), 60), false),
               tile("reflection", std::make_shared<MirrorMaterial>(Color::Constant(0.92)), false),
               tile("refraction", clearGlass(), true)},
              420, 380, "materials.png", context);
}

}  // namespace caustic
