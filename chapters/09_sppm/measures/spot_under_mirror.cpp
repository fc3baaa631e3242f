#include "measures/spot_under_mirror.h"

#include <cmath>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "material/mirror_material.h"
#include "modeler/objects.h"
#include "sampling/sobol_sampler.h"
#include "shape/rectangle.h"

namespace caustic {

Scene SpotUnderMirror::scene() const {
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-9, 0, -9}, {0, 0, 18}, {18, 0, 0}, Color::Constant(floorReflectance)),
                     {std::make_shared<Rectangle>(Vec3(-9, mirrorHeight, -9), Vec3(18, 0, 0), Vec3(0, 0, 18)),
                      std::make_shared<MirrorMaterial>(Color::Ones()),
                      {},
                      nullptr}};
    scene.lights = {
        std::make_shared<ConeLight>(Vec3(0, lampHeight, 0), Vec3::UnitY(), halfAngle, Color::Constant(intensity))};
    scene.camera =
        std::make_shared<PinholeCamera>(Vec3(0.5, 0.4 * mirrorHeight, 0), Vec3::Zero(), Vec3::UnitY(), 1e-5, 1, 1);
    return Scene(scene);
}

Real SpotUnderMirror::truth() const {
    return floorReflectance / std::numbers::pi * intensity / (apparent() * apparent());
}

Real SpotUnderMirror::biasWithin(Real radius) const {
    const Real h = apparent();
    return 1 - 2 * h * h / (radius * radius) * (1 - h / std::hypot(h, radius));
}

Real SpotUnderMirror::found(const SppmSettings& settings, std::int64_t passes, std::uint64_t seed,
                            const std::function<void(std::int64_t, Real)>& look) const {
    const Scene all = scene();
    const SobolSampler sampler(seed);
    const BoxFilter filter;
    SppmSettings own = settings;
    own.limits = {.maxLength = 3, .rouletteStart = 3};  // lamp, mirror, floor, eye
    Sppm sppm(all, sampler, filter, own);
    const auto show = [&](const Rendering& soFar) {
        if (look) look(soFar.passes, developed(sppm, soFar).at(0, 0).x());
        return true;
    };
    return developed(sppm, render(sppm, {.passes = passes, .look = show})).at(0, 0).x();
}

}  // namespace caustic
