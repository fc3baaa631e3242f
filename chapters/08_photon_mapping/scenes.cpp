#include "scenes.h"

#include "camera/pinhole_camera.h"
#include "light/cone_light.h"
#include "material/conductor_material.h"
#include "modeler/objects.h"
#include "shape/ring_cylinder.h"

namespace caustic {

SceneDescription goldRing(int width, int height) {
    constexpr Real above = 1e-3;  // nothing is at the same place as the floor
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-6, 0, -6}, {0, 0, 12}, {12, 0, 0}, Color(0.72, 0.7, 0.66)),
                     // Out of view: walls that bring some light to where the lamp brings none.
                     diffuseRectangle({2.4, 0, -6}, {0, 0, 12}, {0, 5, 0}, Color(0.75, 0.8, 0.85)),
                     diffuseRectangle({-6, 0, -2.4}, {0, 5, 0}, {12, 0, 0}, Color(0.75, 0.8, 0.85)),
                     {std::make_shared<RingCylinder>(ringRadius, 1.04 * ringRadius, above, 0.5),
                      std::make_shared<ConductorMaterial>(Metal::gold()),
                      {},
                      nullptr}};
    const Vec3 lamp(-3.2, 2.6, 0.9);
    scene.lights = {std::make_shared<ConeLight>(lamp, -lamp, 0.75, Color(52, 48, 42))};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(-0.75, 3.3, 2.3), Vec3(0.05, 0.02, 0.08), Vec3::UnitY(), 0.62,
                                                   width, height);
    return scene;
}

}  // namespace caustic
