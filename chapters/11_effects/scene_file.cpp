#include "scene_file.h"

#include <numbers>

#include "camera/thin_lens_camera.h"
#include "image/image.h"
#include "light/area_light.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/environment_map.h"
#include "light/point_light.h"
#include "maps.h"
#include "scene/normal_mapped_shape.h"
#include "scene_json.h"
#include "scene_materials.h"
#include "scene_shapes.h"

namespace caustic {

namespace {

constexpr Real largest = JsonPlace::largest;
constexpr Real degree = std::numbers::pi / 180;

std::shared_ptr<const Camera> readCamera(const JsonPlace& place) {
    place.allow({"position", "target", "up", "fieldOfView", "width", "height", "lens"});
    Real radius = 0;
    Real focus = 1;
    if (const auto lens = place.find("lens")) {
        lens->allow({"radius", "focus"});
        radius = (*lens)["radius"].number(0, largest);
        focus = (*lens)["focus"].number(0, largest);
    }
    const auto up = place.find("up");
    return place.make([&] {
        return std::make_shared<ThinLensCamera>(
            place["position"].vector(), place["target"].vector(), up ? up->vector() : Vec3::UnitZ(),
            place["fieldOfView"].number(0, 180) * degree, static_cast<int>(place["width"].integer(1, 100'000)),
            static_cast<int>(place["height"].integer(1, 100'000)), radius, focus);
    });
}

const std::vector<JsonKind<std::shared_ptr<Light>>>& lightKinds() {
    static const std::vector<JsonKind<std::shared_ptr<Light>>> kinds = {
        {"point",
         {"position", "intensity"},
         [](const JsonPlace& place) {
             return std::make_shared<PointLight>(place["position"].vector(), place["intensity"].color());
         }},
        {"cone",
         {"position", "target", "halfAngle", "intensity"},
         [](const JsonPlace& place) {
             const Vec3 position = place["position"].vector();
             return std::make_shared<ConeLight>(position, place["target"].vector() - position,
                                                place["halfAngle"].number(0, 180) * degree, place["intensity"].color());
         }},
        {"environment", {"radiance", "file", "scale"}, [](const JsonPlace& place) -> std::shared_ptr<Light> {
             const auto file = place.find("file");
             const auto radiance = place.find("radiance");
             if (file.has_value() == radiance.has_value()) place.refuse("needs either a radiance or a file");
             if (radiance) return std::make_shared<ConstantEnvironment>(radiance->color());
             Image image = loadPanorama(fileNamedBy(*file));
             if (const auto scale = place.find("scale")) {
                 const Real factor = scale->number(0, largest);
                 for (int y = 0; y < image.height(); ++y) {
                     for (int x = 0; x < image.width(); ++x) image.set(x, y, factor * image.at(x, y));
                 }
             }
             return environmentLight(std::move(image));
         }}};
    return kinds;
}

SceneObject readObject(const JsonPlace& place, const Named<Material>& materials, const Named<Medium>& media) {
    place.allow({"shape", "transform", "normalMap", "material", "interior", "emission"});
    SceneObject one;
    one.shape = readShape(place["shape"]);
    if (const auto map = place.find("normalMap"))
        one.shape = std::make_shared<NormalMappedShape>(one.shape, readNormalMap(*map));
    if (const auto steps = place.find("transform")) one.shape = moved(one.shape, *steps);
    one.material = namedBy(place.find("material"), materials);
    if (const auto interior = place.find("interior")) {
        interior->allow({"ior", "medium", "priority"});
        const auto ior = interior->find("ior");
        const auto priority = interior->find("priority");
        one.interior = Interior{ior ? ior->number(1e-3, 1e3) : 1, namedBy(interior->find("medium"), media),
                                priority ? static_cast<int>(priority->integer(-1'000'000, 1'000'000)) : 0};
    }
    if (const auto emission = place.find("emission")) {
        one.emission = readTexture(*emission);
        emission->make([&] { return AreaLight(one.shape, one.emission); });
    }
    if (!one.material && !one.interior && !one.emission) place.refuse("needs a material, an interior or an emission");
    return one;
}

SceneMethod readMethod(const JsonPlace& place) {
    place.allow({"type", "segments", "radius", "beamRadius", "photons", "places"});
    SceneMethod method;
    method.type = place["type"].choice({"path", "light", "bidirectional", "photons", "fog"});
    if (const auto found = place.find("segments")) method.segments = static_cast<int>(found->integer(1, 100'000));
    if (const auto found = place.find("radius")) method.radius = found->number(1e-9, largest);
    if (const auto found = place.find("beamRadius")) method.beamRadius = found->number(1e-9, largest);
    if (const auto found = place.find("photons")) method.photons = static_cast<int>(found->integer(1, 1 << 30));
    if (const auto found = place.find("places")) method.places = static_cast<int>(found->integer(1, 100'000));
    return method;
}

void readRender(const JsonPlace& place, SceneFile& scene) {
    place.allow({"method", "passes", "seconds", "exposure", "white"});
    scene.method = readMethod(place["method"]);
    const auto passes = place.find("passes");
    const auto seconds = place.find("seconds");
    if (!passes && !seconds) place.refuse("needs passes or seconds, or both");
    if (passes) scene.limits.passes = passes->integer(1, 1'000'000'000);
    if (seconds) scene.limits.seconds = seconds->number(1e-3, 1e7);
    if (const auto exposure = place.find("exposure")) scene.tone.exposure = exposure->number(1e-9, largest);
    if (const auto white = place.find("white")) scene.tone.white = white->number(1e-9, largest);
}

}  // namespace

SceneFile loadScene(const std::string& file) {
    const JsonPlace top = JsonPlace::ofFile(file);
    top.allow({"$schema", "camera", "materials", "media", "objects", "lights", "render"});
    SceneFile scene;
    scene.description.camera = readCamera(top["camera"]);
    const Named<Material> materials = readNamed<Material>(top, "materials", readMaterial);
    const Named<Medium> media = readNamed<Medium>(top, "media", readMedium);
    for (const JsonPlace& one : top["objects"].items())
        scene.description.objects.push_back(readObject(one, materials, media));
    if (const auto lights = top.find("lights")) {
        for (const JsonPlace& one : lights->items()) scene.description.lights.push_back(makeKind(one, lightKinds()));
    }
    readRender(top["render"], scene);
    return scene;
}

}  // namespace caustic
