#include "measures/pass_states.h"

#include <unistd.h>
#include <algorithm>
#include <fstream>

#include "camera/box_filter.h"
#include "core/progress.h"
#include "integrator/render.h"
#include "measures/mirror_caustic.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

namespace {

constexpr int width = 64;

Real residentMemory() {
    std::ifstream file("/proc/self/statm");
    long all = 0;
    long resident = 0;
    file >> all >> resident;
    return static_cast<Real>(resident) * static_cast<Real>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

std::array<Real, 5> radiiOf(const Sppm& sppm, std::int64_t passes) {
    std::vector<Real> radii;
    const SppmSettings& settings = sppm.settings();
    for (int i = 0; i < width * width; ++i) {
        radii.push_back(settings.rule == RadiusRule::Pass ? radiusOfPass(settings.radius, settings.alpha, passes)
                                                          : sppm.statistics({i % width, i / width}).radius);
    }
    std::sort(radii.begin(), radii.end());
    const std::size_t last = radii.size() - 1;
    return {radii[0], radii[last / 4], radii[last / 2], radii[3 * last / 4], radii[last]};
}

}  // namespace

std::vector<PassState> passStates(FigureContext& context) {
    const Scene scene(mirrorCaustic(width));
    const SobolSampler sampler(context.seed());
    const BoxFilter filter;
    std::vector<PassState> states;
    context.progress().expect(2 * progressSteps);
    for (const Method method : {Method::Pass, Method::Point}) {
        SppmSettings settings = mirrorCausticSettings();
        settings.photons = 1 << 14;
        settings.rule = method == Method::Pass ? RadiusRule::Pass : RadiusRule::Point;
        Sppm sppm(scene, sampler, filter, settings);
        std::int64_t next = 1;
        const auto look = [&](const Rendering& soFar) {
            if (soFar.passes < next) return true;
            next *= 2;
            states.push_back({method, soFar.passes, radiiOf(sppm, soFar.passes), residentMemory()});
            return true;
        };
        render(sppm, {.passes = context.byQuality<std::int64_t>(64, 512),
                      .threads = context.threads(),
                      .look = look,
                      .progress = &context.progress()});
    }
    return states;
}

}  // namespace caustic
