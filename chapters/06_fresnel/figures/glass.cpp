#include "camera/tent_filter.h"
#include "figures.h"
#include "image/image_file.h"
#include "integrator/picture.h"
#include "integrator/ray_tracer.h"
#include "material/dielectric_material.h"
#include "material/refraction_material.h"
#include "sampling/stratified_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

void drawGlass(std::shared_ptr<const Material> glass, const std::string& png, FigureContext& context) {
    const int perAxis = context.byQuality(1, 4);
    const Scene scene(glassScene(std::move(glass), 900, 560));
    const StratifiedSampler sampler(context.seed(), perAxis);
    const TentFilter filter;
    RayTracer tracer(scene, sampler, filter, {.maxDepth = 14, .leastWeight = 4e-3, .shadowSamples = 2});
    saveImage(context.output(png), takePicture(tracer, perAxis * perAxis, {.exposure = 1.3}, context));
}

}  // namespace

void drawGlassWithoutFresnel(FigureContext& context) {
    drawGlass(std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones()), "glass_without.png", context);
}

void drawGlassWithFresnel(FigureContext& context) {
    drawGlass(std::make_shared<DielectricMaterial>(), "glass_with.png", context);
}

}  // namespace caustic
