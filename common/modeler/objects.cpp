#include "modeler/objects.h"

#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"

namespace caustic {

SceneObject diffuseRectangle(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV, const Color& reflectance) {
    return {.shape = std::make_shared<Rectangle>(corner, edgeU, edgeV),
            .material = std::make_shared<DiffuseMaterial>(reflectance)};
}

SceneObject rectangleLamp(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV, const Color& radiance) {
    return {.shape = std::make_shared<Rectangle>(corner, edgeU, edgeV),
            .emission = std::make_shared<ConstantTexture>(radiance)};
}

SceneObject mirrorBall(const Vec3& center, Real radius) {
    return {.shape = std::make_shared<Sphere>(center, radius),
            .material = std::make_shared<MirrorMaterial>(Color::Ones())};
}

SceneObject glassBall(const Vec3& center, Real radius, Real ior) {
    return {.shape = std::make_shared<Sphere>(center, radius),
            .material = std::make_shared<DielectricMaterial>(),
            .interior = Interior{ior, nullptr, 0}};
}

}  // namespace caustic
