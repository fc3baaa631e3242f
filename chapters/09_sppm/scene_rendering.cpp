#include "scene_rendering.h"

#include <cstdio>
#include <limits>

#include "core/check.h"
#include "core/text.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
#include "integrator/checkpoint.h"
#include "integrator/lamp_edges.h"
#include "integrator/render.h"

namespace caustic {

namespace {

SppmSettings settingsOf(const NamedScene& named, const RenderWishes& wishes) {
    checkArgument(wishes.rule == "pass" || wishes.rule == "point", "--rule", wishes.rule, "must be pass or point");
    checkArgument(wishes.photons >= 1 && wishes.photons <= std::numeric_limits<int>::max(), "--photons",
                  std::to_string(wishes.photons), "must be a number of photons");
    checkArgument(wishes.every >= 1, "--every", std::to_string(wishes.every), "must be at least 1");
    SppmSettings settings = named.settings;
    settings.rule = wishes.rule == "pass" ? RadiusRule::Pass : RadiusRule::Point;
    settings.alpha = wishes.alpha;
    if (wishes.radius != 0) settings.radius = wishes.radius;
    settings.photons = static_cast<int>(wishes.photons);
    return settings;
}

std::string nameOf(const NamedScene& named, const SppmSettings& settings, std::uint64_t seed) {
    return named.name + ", seed " + std::to_string(seed) + ", rule " +
           (settings.rule == RadiusRule::Pass ? "pass" : "point") + ", alpha " + formatReal(settings.alpha) +
           ", radius " + formatReal(settings.radius) + ", photons " + std::to_string(settings.photons) + ", segments " +
           std::to_string(settings.limits.maxLength);
}

}  // namespace

std::vector<ChapterOption> renderOptions(RenderWishes& wishes) {
    return {
        {"--alpha", "ALPHA", "Of the rule, between 0 and 1", RangedValue<double>{&wishes.alpha, 0, 1}},
        {"--radius", "METRES", "Of the first pass; 0 for the scene's own", RangedValue<double>{&wishes.radius, 0, 1e6}},
        {"--photons", "N", "Photons a pass", RangedValue<std::int64_t>{&wishes.photons, 1, 1 << 30}},
        {"--checkpoint", "FILE", "Go on from this file when it is there, and write it", TextValue{&wishes.checkpoint}},
        {"--every", "N", "Passes between two checkpoints", RangedValue<std::int64_t>{&wishes.every, 1, 1'000'000'000}}};
}

SceneRendering::SceneRendering(const std::string& scene, const RenderWishes& wishes, const ChapterInputs& chapter,
                               const ChapterOptions& options)
    : named_(namedScene(scene)),
      checkpoint_(wishes.checkpoint),
      threads_(options.threads),
      scene_(named_.make(named_.width, named_.height, (chapter.sourceDir / glassProfile).string())),
      sampler_(options.seed),
      sppm_(scene_, sampler_, filter_, settingsOf(named_, wishes)),
      picture_(nameOf(named_, sppm_.settings(), options.seed)),
      file_(options.out / chapter.name / ("render_" + scene + ".png")) {}

std::vector<PathId> SceneRendering::pathsOf(std::int64_t pass) {
    // By rule Point a pixel has one path a pass.
    if (sppm_.settings().rule == RadiusRule::Point) return pathsOfAllPixels(scene_.camera(), pass);
    if (!edges_) useEdges(edgesOf(0, 1));
    return pathsOfPass(scene_.camera(), *edges_, pathsAtLampEdges, pass);
}

std::vector<std::uint8_t> SceneRendering::edgesOf(int firstRow, int step) const {
    return edgesOfRows(scene_, sampler_, named_.settings.limits, firstRow, step, threads_);
}

void SceneRendering::useEdges(const std::vector<std::uint8_t>& ofAllRows) {
    edges_ = withNeighbours(scene_.camera(), ofAllRows);
}

Rendering SceneRendering::empty() const { return {Film(named_.width, named_.height), {}}; }

Rendering SceneRendering::begun() {
    if (checkpoint_.empty() || !std::filesystem::exists(checkpoint_)) return empty();
    return loadCheckpoint(checkpoint_, picture_, sppm_);
}

bool SceneRendering::saveState(const Rendering& soFar) const {
    if (checkpoint_.empty()) return false;
    saveCheckpoint(checkpoint_, picture_, soFar, sppm_);
    return true;
}

void SceneRendering::savePicture(const Rendering& soFar) const {
    saveImage(file_, toneMapped(developed(sppm_, soFar), named_.exposure, 4));
}

void SceneRendering::finish(const Rendering& all) const {
    requireFinite(all);
    saveState(all);
    savePicture(all);
    if (!sppm_.whyNoPhotons().empty()) std::fprintf(stderr, "warning: %s\n", sppm_.whyNoPhotons().c_str());
    std::printf("%s: %lld passes, %.2f s\n", file_.string().c_str(), static_cast<long long>(all.passes), all.seconds);
}

}  // namespace caustic
