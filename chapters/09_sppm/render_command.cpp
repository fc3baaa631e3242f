#include "render_command.h"

#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>
#include <thread>

#include "camera/box_filter.h"
#include "core/check.h"
#include "core/process.h"
#include "core/progress.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
#include "integrator/checkpoint.h"
#include "integrator/lamp_edges.h"
#include "integrator/render.h"
#include "sampling/sobol_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

SppmSettings settingsOf(const NamedScene& named, const RenderWishes& wishes) {
    checkArgument(wishes.rule == "pass" || wishes.rule == "point", "--rule", wishes.rule, "must be pass or point");
    checkArgument(wishes.photons >= 1 && wishes.photons <= std::numeric_limits<int>::max(), "--photons",
                  std::to_string(wishes.photons), "must be a number of photons");
    SppmSettings settings = named.settings;
    settings.rule = wishes.rule == "pass" ? RadiusRule::Pass : RadiusRule::Point;
    settings.alpha = wishes.alpha;
    if (wishes.radius != 0) settings.radius = wishes.radius;
    settings.photons = static_cast<int>(wishes.photons);
    return settings;
}

// When a rendering ends.
RenderSettings limitsOf(const RenderWishes& wishes) {
    checkArgument(wishes.passes != 0 || wishes.seconds != 0, "--render", "", "needs --passes or --time");
    RenderSettings limits;
    if (wishes.passes != 0) limits.passes = wishes.passes;
    if (wishes.seconds != 0) limits.seconds = wishes.seconds;
    return limits;
}

// Everything that makes a picture another one.
std::string pictureName(const NamedScene& named, const SppmSettings& settings, std::uint64_t seed) {
    return named.name + ", seed " + std::to_string(seed) + ", rule " +
           (settings.rule == RadiusRule::Pass ? "pass" : "point") + ", alpha " + formatReal(settings.alpha) +
           ", radius " + formatReal(settings.radius) + ", photons " + std::to_string(settings.photons) + ", segments " +
           std::to_string(settings.limits.maxLength);
}

// Shows the growing picture in a window: the viewer looks at the file again and again. Ends with the window.
class LivePreview {
public:
    explicit LivePreview(std::filesystem::path file) : file_(std::move(file)) {}
    ~LivePreview() {
        if (viewer_.joinable()) viewer_.join();
    }
    // When the file is there.
    void start() {
        if (viewer_.joinable()) return;
        viewer_ = std::thread([file = file_] {
            const auto self = std::filesystem::read_symlink("/proc/self/exe");
            const auto result = runProcess({(self.parent_path() / "preview").string(), file.string()});
            if (!result || result->exitCode != 0) std::fprintf(stderr, "--preview: no window can be opened here\n");
        });
    }

private:
    std::filesystem::path file_;
    std::thread viewer_;
};

}  // namespace

void renderScene(const std::string& name, const RenderWishes& wishes, const ChapterInputs& chapter,
                 const ChapterOptions& options) {
    const NamedScene& named = namedScene(name);
    RenderSettings settings = limitsOf(wishes);
    checkArgument(wishes.every >= 1, "--every", std::to_string(wishes.every), "must be at least 1");
    const Scene scene(named.make(named.width, named.height, (chapter.sourceDir / glassProfile).string()));
    const SobolSampler sampler(options.seed);
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, settingsOf(named, wishes));
    const std::string picture = pictureName(named, sppm.settings(), options.seed);
    const std::filesystem::path file = options.out / chapter.name / ("render_" + name + ".png");

    Rendering rendering = {Film(named.width, named.height), {}};
    if (!wishes.checkpoint.empty() && std::filesystem::exists(wishes.checkpoint))
        rendering = loadCheckpoint(wishes.checkpoint, picture, sppm);
    const auto savePicture = [&](const Rendering& soFar) {
        saveImage(file, toneMapped(developed(sppm, soFar), named.exposure, 4));
    };
    std::optional<LivePreview> preview;
    if (options.preview) preview.emplace(file);
    auto shown = std::chrono::steady_clock::now();
    const auto look = [&](const Rendering& soFar) {
        if (!wishes.checkpoint.empty() && soFar.passes % wishes.every == 0)
            saveCheckpoint(wishes.checkpoint, picture, soFar, sppm);
        const auto now = std::chrono::steady_clock::now();
        if (preview && (soFar.passes == 1 || now - shown > std::chrono::seconds(1))) {
            shown = now;
            savePicture(soFar);
            preview->start();
        }
        return true;
    };
    Progress progress(name);
    progress.expect(progressSteps);
    settings.threads = options.threads;
    settings.look = look;
    // By rule Point a pixel has one path a pass.
    if (sppm.settings().rule == RadiusRule::Pass)
        settings.choose = withMorePaths(
            scene.camera(), lampEdges(scene, sampler, named.settings.limits, options.threads), pathsAtLampEdges);
    settings.progress = &progress;
    resume(sppm, settings, rendering);
    requireFinite(rendering);
    if (!wishes.checkpoint.empty()) saveCheckpoint(wishes.checkpoint, picture, rendering, sppm);
    savePicture(rendering);
    if (!sppm.whyNoPhotons().empty()) std::fprintf(stderr, "warning: %s\n", sppm.whyNoPhotons().c_str());
    std::printf("%s: %lld passes, %.2f s\n", file.string().c_str(), static_cast<long long>(rendering.passes),
                rendering.seconds);
}

}  // namespace caustic
