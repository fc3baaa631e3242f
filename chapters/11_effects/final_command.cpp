#include "final_command.h"

#include <cstdio>

#include "camera/tent_filter.h"
#include "core/progress.h"
#include "final_scene.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
#include "integrator/checkpoint.h"
#include "integrator/render.h"
#include "integrator/volume_sppm.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

namespace {

// Everything that makes a picture another one.
std::string pictureName(const FinalWishes& wishes, std::uint64_t seed) {
    return "final, seed " + std::to_string(seed) + ", width " + std::to_string(wishes.width) + ", photons " +
           std::to_string(wishes.photons);
}

}  // namespace

VolumeSppmSettings finalSettings(int photons) {
    VolumeSppmSettings settings;
    settings.limits.maxLength = 24;
    settings.radius = 0.006;
    settings.beamRadius = 0.01;
    settings.photons = photons;
    settings.places = 2;
    return settings;
}

Image developedFinal(const Image& radiance) { return toneMapped(radiance, 3, 6); }

void renderFinal(const FinalWishes& wishes, const ChapterInputs& chapter, const ChapterOptions& options) {
    const int width = static_cast<int>(wishes.width);
    const auto asset = [&](const std::string& path) { return chapter.sourceDir / path; };
    const Scene scene(finalScene({}, asset, width, width * 5 / 8));
    const SobolSampler sampler(options.seed);
    const TentFilter filter;
    VolumeSppm sppm(scene, sampler, filter, finalSettings(static_cast<int>(wishes.photons)));
    const std::string picture = pictureName(wishes, options.seed);
    const std::filesystem::path file = options.out / chapter.name / "final.png";

    Rendering rendering = {Film(width, width * 5 / 8), {}};
    if (!wishes.checkpoint.empty() && std::filesystem::exists(wishes.checkpoint))
        rendering = loadCheckpoint(wishes.checkpoint, picture, sppm);
    Progress progress("final");
    progress.expect(progressSteps);
    RenderSettings settings;
    settings.passes = wishes.passes;
    settings.threads = options.threads;
    settings.progress = &progress;
    settings.look = [&](const Rendering& soFar) {
        if (!wishes.checkpoint.empty() && soFar.passes % wishes.every == 0)
            saveCheckpoint(wishes.checkpoint, picture, soFar, sppm);
        return true;
    };
    resume(sppm, settings, rendering);
    requireFinite(rendering);
    if (!wishes.checkpoint.empty()) saveCheckpoint(wishes.checkpoint, picture, rendering, sppm);
    saveImage(file, developedFinal(developed(sppm, rendering)));
    std::printf("%s: %lld passes, %.2f s\n", file.string().c_str(), static_cast<long long>(rendering.passes),
                rendering.seconds);
}

}  // namespace caustic
