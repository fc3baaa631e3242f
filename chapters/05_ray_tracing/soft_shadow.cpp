#include "soft_shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/diffuse_material.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "texture/constant_texture.h"

namespace caustic {

namespace {

constexpr Real lampHeight = 2;

// Form factor of the part of the lamp's plane with corners (0, 0) and (x, z), from the floor below (0, 0); odd in both.
Real cornerFactor(Real x, Real z) {
    const Real a = x / lampHeight;
    const Real b = z / lampHeight;
    const Real ra = std::sqrt(1 + a * a);
    const Real rb = std::sqrt(1 + b * b);
    return (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / (2 * std::numbers::pi);
}

Real rectangleFactor(Real x0, Real x1, Real z0, Real z1) {
    if (x0 >= x1 || z0 >= z1) return 0;
    return cornerFactor(x1, z1) - cornerFactor(x0, z1) - cornerFactor(x1, z0) + cornerFactor(x0, z0);
}

}  // namespace

SceneDescription softShadowScene() {
    const auto white = std::make_shared<DiffuseMaterial>(Color::Ones());
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-1, lampHeight, -1), Vec3(2, 0, 0), Vec3(0, 0, 2));
    lamp.emission = std::make_shared<ConstantTexture>(Color::Ones());
    const SceneObject plate = {
        .shape = std::make_shared<Rectangle>(Vec3(-0.5, lampHeight / 2, -0.5), Vec3(1, 0, 0), Vec3(0, 0, 1)),
        .material = white};
    const SceneObject floor = {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = white};
    SceneDescription scene;
    scene.objects = {floor, plate, lamp};
    return scene;
}

Real softShadow(Real x, Real z) {
    const Real all = rectangleFactor(-1 - x, 1 - x, -1 - z, 1 - z);
    // Seen from the floor the plate, half as high, hides twice its size, mirrored at the point: 2 · plate − point. From
    // there, the point lies at 0.
    const Real hidden = rectangleFactor(std::max(-1 - 2 * x, -1 - x), std::min(1 - 2 * x, 1 - x),
                                        std::max(-1 - 2 * z, -1 - z), std::min(1 - 2 * z, 1 - z));
    return all - hidden;
}

}  // namespace caustic
