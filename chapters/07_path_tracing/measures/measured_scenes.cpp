#include "measures/measured_scenes.h"

#include <algorithm>

#include "core/check.h"
#include "image/image_file.h"
#include "measures/radiosity.h"
#include "modeler/caustic_scene.h"
#include "modeler/peers_box.h"

namespace caustic {

namespace {

constexpr int patches = 20;   // along a wall's edge
constexpr int perAxis = 16;   // rays a pixel, squared
constexpr int segments = 64;  // as good as no end

std::function<Image(int, int)> radiosityOf(const DiffuseBox& box) {
    return [box](int width, int threads) {
        const SceneDescription scene = box.scene(width, width);
        return BoxRadiosity(box, patches, threads).picture(*scene.camera, perAxis, threads);
    };
}

}  // namespace

DiffuseBox smallLampBox() { return {.lampSide = 0.2, .radiance = 100, .mirror = true}; }

const std::vector<MeasuredScene>& measuredScenes() {
    static const std::vector<MeasuredScene> scenes = {
        {"diffuse_box", "diffuse box", 128, segments, [](int width) { return DiffuseBox{}.scene(width, width); },
         radiosityOf({}), "", "radiosity by closed form factors"},
        {"mirror_box", "box with small lamp and mirror", 128, segments,
         [](int width) { return smallLampBox().scene(width, width); }, radiosityOf(smallLampBox()), "",
         "radiosity by closed form factors, the box once more behind the mirror"},
        {"caustic",
         "caustic of a glass ball",
         128,
         segments,
         [](int width) { return CausticScene{}.onFloor(width); },
         {},
         "assets/references/caustic_floor.exr",
         "a program for this scene alone"},
        {"peers_box",
         "peers' box",
         256,
         peersBoxSegments,
         [](int width) { return peersBox(width, width); },
         {},
         "assets/references/peers_box.exr",
         "bidirectional path tracing, long converged"}};
    return scenes;
}

std::vector<std::string> measuredSceneNames() {
    std::vector<std::string> names;
    for (const MeasuredScene& scene : measuredScenes()) names.push_back(scene.name);
    return names;
}

const MeasuredScene& measuredScene(const std::string& name) {
    for (const MeasuredScene& scene : measuredScenes()) {
        if (scene.name == name) return scene;
    }
    throw InputError({"measured scenes", 0}, name, "there is none of that name");
}

Image referenceOf(const MeasuredScene& scene, int width, const std::filesystem::path& file, int threads) {
    return scene.compute ? scene.compute(width, threads) : shrunk(loadImage(file), width);
}

Image shrunk(const Image& picture, int width) {
    checkArgument(width >= 1 && picture.width() % width == 0, "width", std::to_string(width),
                  "must divide the picture's " + std::to_string(picture.width()));
    const int block = picture.width() / width;
    const int height = picture.height() / block;
    Image small(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Color sum = Color::Zero();
            for (int i = 0; i < block * block; ++i) sum += picture.at(x * block + i % block, y * block + i / block);
            small.set(x, y, sum / (block * block));
        }
    }
    return small;
}

}  // namespace caustic
