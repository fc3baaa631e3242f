#include "integrator/timed_render.h"

#include <algorithm>

#include "core/check.h"
#include "core/thread_clock.h"

namespace caustic {

namespace {

std::vector<PathId> allPixels(const Camera& camera) {
    std::vector<PathId> paths;
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) paths.push_back({{x, y}, 0});
    }
    return paths;
}

}  // namespace

Rendering renderFor(const Integrator& integrator, double seconds,
                    const std::function<bool(const Rendering&, const TimedMoment&)>& look) {
    checkPositive(seconds, "seconds to render");
    const Camera& camera = integrator.scene().camera();
    Rendering rendering = {Film(camera.width(), camera.height()), {}};
    std::vector<PathId> paths = allPixels(camera);
    TimedMoment now;
    double longest = 0;
    do {
        const double start = threadSeconds();
        addPass(integrator, paths, 1, rendering);
        for (PathId& path : paths) ++path.index;
        const double taken = threadSeconds() - start;
        longest = std::max(longest, taken);
        now = {now.samples + 1, now.seconds + taken};
        if (look && !look(rendering, now)) break;
    } while (now.seconds + longest <= seconds);
    return rendering;
}

}  // namespace caustic
