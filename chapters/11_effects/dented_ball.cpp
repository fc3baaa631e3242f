#include "dented_ball.h"

#include <utility>

#include "bare_normals.h"
#include "camera/pinhole_camera.h"
#include "material/mirror_material.h"
#include "patterns.h"
#include "scene/normal_mapped_shape.h"
#include "shape/sphere.h"

namespace caustic {

SceneDescription dentedBall(Normals normals, Lookup lookup, std::shared_ptr<Light> sky, int side) {
    std::shared_ptr<const Shape> ball = std::make_shared<Sphere>(Vec3::Zero(), 1);
    const auto map = std::make_shared<NormalMap>(normalsOfHeights(hammeredPattern(64, 5, 0.22, 5)), lookup, Vec2(4, 2));
    if (normals == Normals::Bare) ball = std::make_shared<BareNormals>(ball, map);
    if (normals == Normals::Mapped) ball = std::make_shared<NormalMappedShape>(ball, map);
    SceneDescription scene;
    scene.objects = {{ball, std::make_shared<MirrorMaterial>(Color(0.93, 0.92, 0.9))}};
    scene.lights = {std::move(sky)};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.8, 0.5, 6), Vec3::Zero(), Vec3::UnitY(), 0.36, side, side);
    return scene;
}

int blackPixels(const Image& picture) {
    int black = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) black += picture.at(x, y).maxCoeff() == 0 ? 1 : 0;
    }
    return black;
}

}  // namespace caustic
