#include "render_command.h"

#include <cmath>
#include <cstdio>

#include "core/check.h"
#include "core/progress.h"
#include "figures/heat.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
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
    const auto save = [&](const Rendering& rendering) {
        requireFinite(rendering);
        const std::filesystem::path file = folder / ("render_" + name + ".png");
        saveImage(file, toneMapped(rendering.film.image(), what.tone.exposure, what.tone.white));
        std::printf("%s: %lld passes, %.2f s\n", file.string().c_str(), static_cast<long long>(rendering.passes),
                    rendering.seconds);
    };
    if (wishes.rule == "uniform") {
        settings.passes = wishes.paths;
        return save(render(*inner, settings));
    }
    const auto rule = makeRule(wishes, scene, options.threads);
    const std::int64_t pixels = std::int64_t{scene.camera().width()} * scene.camera().height();
    AdaptiveIntegrator adaptive(*inner, *sampler, *rule,
                                {.batch = 4, .first = 16, .paths = wishes.paths * pixels, .share = 0.05});
    const Rendering rendering = renderAdaptively(adaptive, settings);
    save(rendering);
    saveImage(folder / ("render_" + name + "_paths.png"), heatMap(adaptive, 16, 1024));
}

}  // namespace caustic
