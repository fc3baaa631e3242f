#include "scenes.h"

#include <cmath>
#include <numbers>

#include "camera/pinhole_camera.h"
#include "core/check.h"
#include "light/cone_light.h"
#include "light/point_light.h"
#include "modeler/caustic_scene.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "modeler/peers_box.h"
#include "modeler/wine_glass.h"

namespace caustic {

namespace {

SppmSettings settingsFor(int mostSegments, Real radius = 0) {
    SppmSettings settings;
    settings.limits.maxLength = mostSegments;
    settings.radius = radius;
    return settings;
}

}  // namespace

SceneDescription pointLitBox(int width, int height) {
    SceneDescription scene = peersBox(width, height);
    std::erase_if(scene.objects, [](const SceneObject& one) {
        // The lamp and its four sides.
        return one.shape->bounds().min().z() > 1.2 && one.shape->bounds().sizes().x() < 1;
    });
    scene.lights = {std::make_shared<PointLight>(Vec3(0, -0.5, 1), Color::Constant(70 / (4 * std::numbers::pi)))};
    return scene;
}

SceneDescription wineGlassScene(const std::string& file, bool wine, int width, int height) {
    const WineGlass glass = {loadOutline(file)};
    SceneDescription scene;
    if (wine) {
        scene.objects = glass.objects();
    } else {
        scene.objects = {glass.glass()};
    }
    constexpr Real below = -1e-4;  // the foot stands on it, and nothing is at the same place
    scene.objects.push_back(diffuseRectangle({-1.6, below, -1}, {0, 0, 3}, {3.2, 0, 0}, Color(0.74, 0.7, 0.64)));
    scene.objects.push_back(diffuseRectangle({-1.6, below, -1}, {3.2, 0, 0}, {0, 1.6, 0}, Color(0.3, 0.36, 0.42)));
    scene.objects.push_back(rectangleLamp({-0.9, 0.1, 0.4}, {0, 0.9, 0}, {0.5, 0, 0.5}, Color(1.3, 1.5, 1.8)));
    const Vec3 lamp(-0.3, 0.56, -0.34);
    scene.lights = {std::make_shared<ConeLight>(lamp, Vec3(0.06, 0, 0.08) - lamp, 0.62, Color(1.7, 1.55, 1.3))};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.12, 0.4, 0.8), Vec3(0.04, 0.075, 0.04), Vec3::UnitY(), 0.42,
                                                   width, height);
    return scene;
}

const std::vector<NamedScene>& namedScenes() {
    static const std::vector<NamedScene> scenes = {
        {"peers_box", 256, 256, 1, settingsFor(peersBoxSegments),
         [](int width, int height, const std::string&) { return peersBox(width, height); }},
        {"point_box", 256, 256, 1, settingsFor(peersBoxSegments),
         [](int width, int height, const std::string&) { return pointLitBox(width, height); }},
        {"diffuse_box", 256, 256, 1, settingsFor(64),
         [](int width, int height, const std::string&) { return DiffuseBox{}.scene(width, height); }},
        {"caustic_mirror", 400, 300, 1, settingsFor(16, 0.03),
         [](int width, int height, const std::string&) {
             return CausticScene{.lampSide = 0.2}.beforeMirror(width, height);
         }},
        {"thumbnail", 40, 30, 1, settingsFor(16, 0.1),
         [](int width, int height, const std::string&) { return CausticScene{}.beforeMirror(width, height); }},
        {"wine_glass", 450, 600, 1, settingsFor(24, 6e-3),
         [](int width, int height, const std::string& glass) { return wineGlassScene(glass, true, width, height); }},
        {"empty_glass", 450, 600, 1, settingsFor(24, 6e-3),
         [](int width, int height, const std::string& glass) { return wineGlassScene(glass, false, width, height); }}};
    return scenes;
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const NamedScene& scene : namedScenes()) names.push_back(scene.name);
    return names;
}

const NamedScene& namedScene(const std::string& name) {
    std::string names;
    for (const NamedScene& scene : namedScenes()) {
        if (scene.name == name) return scene;
        names += (names.empty() ? "" : ", ") + scene.name;
    }
    throw InputError({"scene", 0}, name, "no such scene; there are " + names);
}

}  // namespace caustic
