#include "measures/needs_command.h"

#include "camera/box_filter.h"
#include "core/check.h"
#include "figure/timing.h"
#include "integrator/render.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "measures/measured_scenes.h"
#include "medium/absorbing_medium.h"
#include "methods.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "shape/rectangle.h"
#include "texture/checker_texture.h"

namespace caustic {

namespace {

constexpr int width = 32;
constexpr long long mostSamples = 1'000'000;

SceneDescription pointLamp() {
    SceneDescription room = DiffuseBox{}.scene(width, width);
    std::erase_if(room.objects, [](const SceneObject& one) { return one.emission != nullptr; });
    room.lights = {std::make_shared<PointLight>(Vec3(0, 0, 0.8), Color::Ones())};
    return room;
}

SceneDescription mirror() { return smallLampBox().scene(width, width); }

SceneDescription glass() {
    SceneDescription room = mirror();
    room.objects.push_back(glassBall({0.2, 0, -0.5}, 0.4, 1.5));
    return room;
}

SceneDescription mediumAndTexture() {
    SceneDescription room = glass();
    room.objects.back().interior->medium =
        std::make_shared<AbsorbingMedium>(AbsorbingMedium::ofTransmittance(Color(0.5, 0.9, 0.6)));
    const auto board = std::make_shared<CheckerTexture>(Color::Constant(0.8), Color::Constant(0.3), 0.25);
    room.objects.front().material = std::make_shared<DiffuseMaterial>(board);
    return room;
}

std::int64_t numberBelow(const std::string& text, const std::string& option, long long end) {
    const auto number = parseInteger(text);
    checkArgument(number && *number >= 0 && *number < end, option, text,
                  "must be an integer from 0 to " + std::to_string(end - 1));
    return *number;
}

}  // namespace

const std::vector<NeedyScene>& needyScenes() {
    static const std::vector<NeedyScene> scenes = {{"point lamp", pointLamp},
                                                   {"area lamp", [] { return DiffuseBox{}.scene(width, width); }},
                                                   {"mirror", mirror},
                                                   {"glass", glass},
                                                   {"absorption and textures", mediumAndTexture}};
    return scenes;
}

void tracePaths(const std::string& scene, const std::string& method, const std::string& samples) {
    const auto& scenes = needyScenes();
    const std::int64_t which = numberBelow(scene, "--trace", static_cast<long long>(scenes.size()));
    const std::int64_t how = numberBelow(method, "--method", static_cast<long long>(allMethods.size()));
    const std::int64_t paths = numberBelow(samples, "--samples", mostSamples);
    const Scene made(scenes[static_cast<std::size_t>(which)].make());
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    const auto integrator = makeIntegrator(allMethods[static_cast<std::size_t>(how)], made, sampler, filter, 10);
    if (paths > 0) keep(render(*integrator, {.passes = paths}).film.value({0, 0}));
}

}  // namespace caustic
