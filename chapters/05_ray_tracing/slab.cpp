#include "slab.h"

#include <cmath>

#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "shape/box.h"
#include "shape/rectangle.h"
#include "texture/constant_texture.h"

namespace caustic {

SceneDescription slabScene(Real reflectance, Real sigma) {
    SceneObject pane;
    pane.shape = std::make_shared<Box>(Vec3(0, -9, -9), Vec3(1, 9, 9));
    pane.material =
        std::make_shared<RefractionMaterial>(Color::Constant(reflectance), Color::Constant(1 - reflectance));
    pane.interior = Interior{1.5, std::make_shared<AbsorbingMedium>(Color::Constant(sigma)), 0};
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(3, -9, -9), Vec3(0, 0, 18), Vec3(0, 18, 0));  // faces −x
    lamp.emission = std::make_shared<ConstantTexture>(Color::Ones());
    SceneDescription scene;
    scene.objects = {pane, lamp};
    return scene;
}

Real slabTransmission(Real reflectance, Real sigma) {
    const Real a = std::exp(-sigma);
    return (1 - reflectance) * (1 - reflectance) * a / (1 - reflectance * reflectance * a * a);
}

}  // namespace caustic
