#include "render_command.h"

#include <cmath>
#include <cstdio>

#include "core/check.h"
#include "core/progress.h"
#include "core/text.h"
#include "figures/heat.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
#include "integrator/checkpoint.h"
#include "sampling/sampler_names.h"
#include "scenes.h"

namespace caustic {

namespace {

std::unique_ptr<AdaptiveRule> makeRule(const RenderWishes& wishes, const Scene& scene, int threads) {
    RayCounts counts;
    if (wishes.rule == "hash") return std::make_unique<HashRule>(scene, 12, threads, counts);
    if (wishes.rule == "edges") return std::make_unique<EdgeRule>(0.04);
    if (wishes.rule == "interval") return std::make_unique<IntervalRule>(wishes.tolerance);
    checkArgument(wishes.rule == "gain", "rule", wishes.rule, "must be uniform, hash, edges, interval or gain");
    return std::make_unique<GainRule>();
}

// Everything that a path depends on, and who gets it: more paths only go on. Strata alone know how many there will be.
std::string pictureName(const std::string& scene, const RenderWishes& wishes, std::uint64_t seed) {
    std::string name = scene + ", width " + std::to_string(wishes.width) + ", seed " + std::to_string(seed) + ", " +
                       wishes.sampler + ", rule " + wishes.rule;
    if (wishes.sampler == "stratified") name += ", " + std::to_string(wishes.paths) + " paths";
    if (wishes.rule == "interval") name += ", tolerance " + formatReal(wishes.tolerance);
    return name;
}

}  // namespace

const std::vector<std::string>& ruleNames() {
    static const std::vector<std::string> names = {"uniform", "hash", "edges", "interval", "gain"};
    return names;
}

void renderScene(const std::string& name, const RenderWishes& wishes, const ChapterInputs& chapter,
                 const ChapterOptions& options) {
    const Study& what = study(name);
    checkArgument(wishes.width >= 8 && wishes.width <= 4096, "--width", std::to_string(wishes.width),
                  "must be 8 to 4096");
    const auto sampler = makeSampler(wishes.sampler, options.seed, wishes.paths);
    const Scene scene = what.scene((chapter.sourceDir / what.asset).string(), static_cast<int>(wishes.width));
    const auto inner = what.method(scene, *sampler);
    const std::filesystem::path folder = options.out / chapter.name;
    Progress progress(name);
    progress.expect(progressSteps);
    RenderSettings settings = {.threads = options.threads, .progress = &progress};
    const auto draw = [&](Integrator& integrator) {
        const std::string picture = pictureName(name, wishes, options.seed);
        Rendering rendering = {Film(scene.camera().width(), scene.camera().height()), {}};
        if (!wishes.checkpoint.empty() && std::filesystem::exists(wishes.checkpoint))
            rendering = loadCheckpoint(wishes.checkpoint, picture, integrator);
        resume(integrator, settings, rendering);
        requireFinite(rendering);
        if (!wishes.checkpoint.empty()) saveCheckpoint(wishes.checkpoint, picture, rendering, integrator);
        const std::filesystem::path file = folder / ("render_" + name + ".png");
        saveImage(file, toneMapped(rendering.film.image(), what.tone.exposure, what.tone.white));
        std::printf("%s: %lld passes, %.2f s\n", file.string().c_str(), static_cast<long long>(rendering.passes),
                    rendering.seconds);
    };
    if (wishes.rule == "uniform") {
        settings.passes = wishes.paths;
        return draw(*inner);
    }
    const auto rule = makeRule(wishes, scene, options.threads);
    const std::int64_t pixels = std::int64_t{scene.camera().width()} * scene.camera().height();
    AdaptiveIntegrator adaptive(*inner, *sampler, *rule,
                                {.batch = 4, .first = 16, .paths = wishes.paths * pixels, .share = 0.05});
    settings.choose = [&adaptive](const Rendering&) { return adaptive.next(); };
    draw(adaptive);
    saveImage(folder / ("render_" + name + "_paths.png"), heatMap(adaptive, 16, 1024));
}

}  // namespace caustic
