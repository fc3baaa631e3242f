#include "fluted_cup.h"

#include "camera/pinhole_camera.h"
#include "chosen_as.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "material/dielectric_material.h"
#include "modeler/objects.h"
#include "modeler/wine_glass.h"
#include "patterns.h"
#include "scene/normal_mapped_shape.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

namespace {

SceneDescription cupOnTable(std::optional<Lookup> lookup, const std::filesystem::path& profile) {
    std::shared_ptr<const Shape> cup = std::make_shared<SurfaceOfRevolution>(loadOutline(profile.string()));
    if (lookup) {
        const Image heights = flutedPattern(64, 192, 14, 0.3, 0.6, 0.35);
        cup = std::make_shared<NormalMappedShape>(cup, std::make_shared<NormalMap>(normalsOfHeights(heights), *lookup));
    }
    SceneDescription scene;
    scene.objects = {{cup, std::make_shared<DielectricMaterial>(), Interior{1.5, nullptr, 0}},
                     diffuseRectangle({-0.4, -1e-4, 0.4}, {0.8, 0, 0}, {0, 0, -0.8}, Color(0.72, 0.68, 0.6))};
    const Vec3 lamp(-0.28, 0.26, -0.22);
    scene.lights = {std::make_shared<ConeLight>(lamp, Vec3(0.01, 0.02, 0.01) - lamp, 0.35, Color(0.36, 0.33, 0.28)),
                    std::make_shared<ChosenAs>(std::make_shared<ConstantEnvironment>(Color(0.1, 0.12, 0.16)), 0.09)};
    return scene;
}

}  // namespace

SceneDescription flutedCup(std::optional<Lookup> lookup, const std::filesystem::path& profile, int width, int height) {
    SceneDescription scene = cupOnTable(lookup, profile);
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.06, 0.22, 0.33), Vec3(0.035, 0.015, 0.02), Vec3::UnitY(),
                                                   0.46, width, height);
    return scene;
}

SceneDescription flutedCupsCaustic(std::optional<Lookup> lookup, const std::filesystem::path& profile, int side) {
    SceneDescription scene = cupOnTable(lookup, profile);
    scene.lights.pop_back();  // the sky
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.105, 0.3, 0.085), Vec3(0.105, 0, 0.085), -Vec3::UnitZ(), 0.3,
                                                   side, side);
    return scene;
}

}  // namespace caustic
