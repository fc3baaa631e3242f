#include "measures/needs_command.h"

#include "camera/box_filter.h"
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

}  // namespace

const std::vector<NeedyScene>& needyScenes() {
    static const std::vector<NeedyScene> scenes = {{"point lamp", pointLamp},
                                                   {"area lamp", [] { return DiffuseBox{}.scene(width, width); }},
                                                   {"mirror", mirror},
                                                   {"glass", glass},
                                                   {"absorption and textures", mediumAndTexture}};
    return scenes;
}

void tracePaths(std::int64_t scene, std::int64_t method, std::int64_t samples) {
    const Scene made(needyScenes().at(static_cast<std::size_t>(scene)).make());
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    const auto integrator = makeIntegrator(allMethods.at(static_cast<std::size_t>(method)), made, sampler, filter, 10);
    keep(render(*integrator, {.passes = samples}).film.value({0, 0}));
}

}  // namespace caustic
