#include "integrator/render.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/check.h"
#include "core/progress.h"
#include "core/thread_clock.h"

namespace caustic {

namespace {

void check(const RenderSettings& settings) {
    checkArgument(settings.passes >= 1, "passes", std::to_string(settings.passes), "must be at least 1");
    checkArgument(settings.seconds > 0, "seconds to render", formatReal(settings.seconds), "must be greater than 0");
    checkArgument(settings.threads >= 1, "threads", std::to_string(settings.threads), "must be at least 1");
    const RenderSettings unlimited;
    checkArgument(
        settings.passes < unlimited.passes || settings.seconds < unlimited.seconds || settings.look || settings.choose,
        "rendering", "", "needs a limit: passes, seconds, or something that says when to stop");
}

// Tells a Progress how much of a rendering is done.
class ProgressShare {
public:
    explicit ProgressShare(const RenderSettings& settings) : settings_(settings) {}

    void show(const Rendering& rendering) {
        const double ofPasses = static_cast<double>(rendering.passes) / static_cast<double>(settings_.passes);
        advanceTo(std::min(1.0, std::max(ofPasses, rendering.seconds / settings_.seconds)));
    }
    void end() { advanceTo(1); }

private:
    void advanceTo(double share) {
        const auto steps = static_cast<std::int64_t>(share * progressSteps);
        if (settings_.progress != nullptr && steps > told_) settings_.progress->advance(steps - told_);
        told_ = std::max(told_, steps);
    }

    const RenderSettings& settings_;
    std::int64_t told_ = 0;
};

}  // namespace

Rendering render(Integrator& integrator, const RenderSettings& settings) {
    check(settings);
    const Camera& camera = integrator.scene().camera();
    Rendering rendering = {Film(camera.width(), camera.height()), {}};
    resume(integrator, settings, rendering);
    return rendering;
}

void resume(Integrator& integrator, const RenderSettings& settings, Rendering& rendering) {
    check(settings);
    ProgressShare progress(settings);
    std::vector<PathId> paths;
    if (!settings.choose) paths = pathsOfAllPixels(integrator.scene().camera(), rendering.passes);
    double longest = rendering.passes > 0 ? rendering.seconds / static_cast<double>(rendering.passes) : 0;
    while (rendering.passes < settings.passes &&
           (rendering.passes == 0 || rendering.seconds + longest <= settings.seconds)) {
        if (settings.choose) paths = settings.choose(rendering);
        if (paths.empty()) break;
        const double start = computingSeconds(settings.threads);
        Rendering pass = integrator.runPass({rendering.passes, paths}, settings.threads);
        pass.seconds = computingSeconds(settings.threads) - start;
        longest = std::max(longest, pass.seconds);
        rendering.merge(pass);
        if (!settings.choose) {
            for (PathId& path : paths) ++path.index;
        }
        progress.show(rendering);
        if (settings.look && !settings.look(rendering)) break;
    }
    progress.end();
}

std::vector<PathId> pathsOfAllPixels(const Camera& camera, std::int64_t index) {
    std::vector<PathId> paths;
    paths.reserve(static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height()));
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) paths.push_back({{x, y}, index});
    }
    return paths;
}

Image developed(const Integrator& integrator, const Rendering& rendering) {
    Image picture = rendering.film.image();
    integrator.develop(picture);
    return picture;
}

void requireFinite(const Rendering& rendering) {
    const auto& bad = rendering.film.firstBad();
    if (!bad) return;
    throw std::runtime_error(std::to_string(rendering.film.badSamples()) +
                             " samples are not finite; first that of pixel (" + std::to_string(bad->pixel.x) + ", " +
                             std::to_string(bad->pixel.y) + "), sample " + std::to_string(bad->index));
}

}  // namespace caustic
