#include <cmath>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/progress.h"
#include "figures.h"
#include "image/image_file.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "integrator/picture.h"
#include "integrator/volume_sppm.h"
#include "light/cone_light.h"
#include "measures/air_light.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "modeler/objects.h"
#include "modeler/wine_glass.h"
#include "sampling/sobol_sampler.h"
#include "shape/sphere.h"

namespace caustic {

namespace {

// A glass of wine under a spotlight, in a ball of faint fog.
SceneDescription glassInFog(const std::string& outline, int width, int height) {
    WineGlass glass = {loadOutline(outline)};
    glass.wineSigmaA = {2, 14, 10};
    SceneDescription scene;
    scene.objects = glass.objects();
    scene.objects.push_back(diffuseRectangle({-1.6, -1e-4, -1}, {0, 0, 3}, {3.2, 0, 0}, Color(0.5, 0.47, 0.43)));
    scene.objects.push_back(diffuseRectangle({-1.6, -1e-4, -0.6}, {3.2, 0, 0}, {0, 1.6, 0}, Color(0.08, 0.09, 0.11)));
    const auto fog = std::make_shared<HomogeneousMedium>(Color::Constant(0.05), Color(0.5, 0.5, 0.5),
                                                         std::make_shared<HenyeyGreenstein>(0.3));
    scene.objects.push_back({.shape = std::make_shared<Sphere>(Vec3(0, 0.2, 0), 2), .interior = Interior{1, fog, -1}});
    const Vec3 lamp(-0.42, 0.46, -0.08);
    scene.lights = {std::make_shared<ConeLight>(lamp, Vec3(0, 0.14, 0) - lamp, 0.13, Color(6.5, 6, 5.3))};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.14, 0.24, 0.72), Vec3(0.045, 0.125, 0), Vec3::UnitY(), 0.5,
                                                   width, height);
    return scene;
}

Image inFog(const Scene& scene, const VolumeSppmSettings& settings, std::int64_t passes, const PictureTone& tone,
            FigureContext& context) {
    const SobolSampler sampler(context.seed());
    const BoxFilter filter;
    VolumeSppm sppm(scene, sampler, filter, settings);
    return toneMapped(renderImage(sppm, passes, context, &context.progress()), tone.exposure, tone.white);
}

}  // namespace

void drawVolumeLight(FigureContext& context) {
    const int width = context.byQuality(150, 420);
    context.progress().expect(progressSteps);
    const Scene scene(glassInFog(context.asset("assets/profiles/wine_glass.svg").string(), width, width * 4 / 3));
    VolumeSppmSettings settings;
    settings.limits = {.maxLength = 16, .rouletteStart = 4};
    settings.radius = 5e-3;
    settings.beamRadius = 8e-3;
    settings.photons = context.byQuality(1 << 15, 1 << 17);
    settings.places = 8;
    saveImage(context.output("volume_light.png"), inFog(scene, settings, context.byQuality(4, 16), {1.8, 4}, context));
}

void drawGlow(FigureContext& context) {
    const int side = context.byQuality(200, 320);
    context.progress().expect(3 * progressSteps);
    const AirLight light;
    const auto tile = [&](const std::string& caption, MediumDirect direct, int places, std::int64_t passes) {
        return Tile{caption, [&context, light, direct, places, passes](int width, int height) {
                        const Scene scene(light.scene(width, height));
                        VolumeSppmSettings settings;
                        settings.limits = {.maxLength = 2, .rouletteStart = 9};
                        settings.beamRadius = 0.12;
                        settings.photons = direct == MediumDirect::Photons ? 1 << 16 : 0;
                        settings.direct = direct;
                        settings.places = places;
                        return inFog(scene, settings, passes, {1.5, 4}, context);
                    }};
    };
    drawTiles({tile("marching", MediumDirect::Marching, 16, context.byQuality(1, 4)),
               tile("photons", MediumDirect::Photons, 1, context.byQuality(1, 8)),
               tile("equi-angular", MediumDirect::EquiAngular, 8, 1)},
              side, side, "glow.png", context);
}

}  // namespace caustic
