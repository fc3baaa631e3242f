#include <memory>

#include "camera/pinhole_camera.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "light/constant_environment.h"
#include "light/environment_map.h"
#include "maps.h"
#include "material/conductor_material.h"
#include "material/diffuse_material.h"
#include "material/rough_conductor_material.h"
#include "modeler/objects.h"
#include "shape/sphere.h"

namespace caustic {

namespace {

// y is up: the panorama's zenith is turned there.
const Frame upright = {Vec3(0, 0, -1), Vec3(-1, 0, 0), Vec3(0, 1, 0)};

SceneObject ball(Real x, std::shared_ptr<const Material> material) {
    return {std::make_shared<Sphere>(Vec3(x, 0.501, 0), 0.5), std::move(material)};
}

// Gold, plaster, rough silver and glass on a slab.
SceneDescription fourBalls(std::shared_ptr<Light> sky, int width, int height) {
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-3, 0, 2}, {6, 0, 0}, {0, 0, -4}, Color(0.5, 0.47, 0.42)),
                     ball(-1.65, std::make_shared<ConductorMaterial>(Metal::gold())),
                     ball(-0.55, std::make_shared<DiffuseMaterial>(Color(0.8, 0.78, 0.74))),
                     ball(0.55, std::make_shared<RoughConductorMaterial>(Metal::silver(), 0.2, 0.2)),
                     glassBall({1.65, 0.501, 0}, 0.5, 1.5)};
    scene.lights = {std::move(sky)};
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0, 1.5, 6.2), Vec3(0, 0.42, 0), Vec3::UnitY(), 0.36, width, height);
    return scene;
}

}  // namespace

void drawEnvironment(FigureContext& context) {
    const auto tile = [&](const std::string& caption, const auto& makeSky, std::int64_t paths, Real exposure) {
        return Tile{caption, [&context, makeSky, paths, exposure](int width, int height) {
                        return tracedPicture(Scene(fourBalls(makeSky(), width, height)), paths, {.exposure = exposure},
                                             context);
                    }};
    };
    const auto hall = [&] {
        return environmentLight(loadPanorama(context.asset("assets/environments/esplanade.exr")), upright);
    };
    const auto mean = [&]() -> std::shared_ptr<Light> {
        const EnvironmentMap map(loadPanorama(context.asset("assets/environments/esplanade.exr")));
        return std::make_shared<ConstantEnvironment>(map.mean());
    };
    const auto sunny = [] { return environmentLight(sunnySky(256), upright); };
    const auto sunnyEvenly = [] { return evenlySampled(environmentLight(sunnySky(256), upright)); };
    const std::int64_t paths = context.byQuality(1, 64);
    const std::string times = std::to_string(paths) + " paths";
    drawTiles({tile("the mean colour of a hall from all around", mean, paths, 0.5), tile("the hall", hall, paths, 0.5),
               tile("a sky with a small sun, directions even: " + times, sunnyEvenly, paths, 1.0),
               tile("the same, directions by brightness: " + times, sunny, paths, 1.0)},
              600, 250, "environment.png", context, 2);
}

}  // namespace caustic
