#include "scene_command.h"

#include <cstdio>
#include <memory>

#include "camera/box_filter.h"
#include "core/error.h"
#include "core/progress.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "integrator/sppm.h"
#include "integrator/volume_sppm.h"
#include "sampling/sobol_sampler.h"
#include "scene_file.h"

namespace caustic {

namespace {

std::unique_ptr<Integrator> makeIntegrator(const SceneMethod& method, const Scene& scene, const Sampler& sampler,
                                           const PixelFilter& filter) {
    const PathLimits limits = {.maxLength = method.segments, .rouletteStart = 4};
    if (method.type == "path")
        return std::make_unique<PathTracer>(scene, sampler, filter, PathTracerSettings{limits, Direct::Mis});
    if (method.type == "light") return std::make_unique<LightTracer>(scene, sampler, filter, limits);
    if (method.type == "bidirectional")
        return std::make_unique<BidirectionalPathTracer>(scene, sampler, filter, limits);
    if (method.type == "photons") {
        SppmSettings settings;
        settings.limits = limits;
        settings.radius = method.radius;
        settings.photons = method.photons;
        return std::make_unique<Sppm>(scene, sampler, filter, settings);
    }
    VolumeSppmSettings settings;
    settings.limits = limits;
    settings.radius = method.radius;
    settings.beamRadius = method.beamRadius;
    settings.photons = method.photons;
    settings.places = method.places;
    return std::make_unique<VolumeSppm>(scene, sampler, filter, settings);
}

}  // namespace

void renderOwnScene(const std::string& file, const ChapterInputs& chapter, const ChapterOptions& options) {
    const SceneFile own = loadScene(file);
    const Scene scene(own.description);
    if (scene.lights().empty()) throw InputError({file, 0}, "", "nothing shines: there is no light and no emission");
    const SobolSampler sampler(options.seed);
    const BoxFilter filter;
    const auto integrator = makeIntegrator(own.method, scene, sampler, filter);
    Progress progress(std::filesystem::path(file).stem().string());
    progress.expect(progressSteps);
    RenderSettings settings = own.limits;
    settings.threads = options.threads;
    settings.progress = &progress;
    const Rendering rendering = render(*integrator, settings);
    requireFinite(rendering);
    const std::filesystem::path picture =
        options.out / chapter.name / (std::filesystem::path(file).stem().string() + ".png");
    saveImage(picture, toneMapped(developed(*integrator, rendering), own.tone.exposure, own.tone.white));
    std::printf("%s: %lld passes, %.2f s\n", picture.string().c_str(), static_cast<long long>(rendering.passes),
                rendering.seconds);
}

}  // namespace caustic
