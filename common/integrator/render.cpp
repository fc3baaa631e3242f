#include "integrator/render.h"

#include <string>

#include "core/check.h"
#include "core/progress.h"

namespace caustic {

namespace {

constexpr std::size_t mostPathsAtOnce = std::size_t{1} << 16;

}  // namespace

void addPass(const Integrator& integrator, std::span<const PathId> paths, int threads, Rendering& rendering) {
    const PassBuffer buffer = integrator.runPass(paths, threads);
    for (std::size_t i = 0; i < paths.size(); ++i) rendering.film.add(paths[i].pixel, paths[i].index, buffer.values[i]);
    for (const Splat& splat : buffer.splats) rendering.film.splat(splat.film, splat.value, integrator.filter());
    rendering.film.countSplatPaths(static_cast<std::int64_t>(paths.size()));
    rendering.counts += buffer.counts;
}

Rendering render(const Integrator& integrator, std::int64_t samples, int threads, Progress* progress) {
    checkArgument(samples >= 1, "samples a pixel", std::to_string(samples), "must be at least 1");
    const Camera& camera = integrator.scene().camera();
    Rendering rendering = {Film(camera.width(), camera.height()), {}};
    std::vector<PathId> paths;
    std::int64_t pixels = 0;
    const auto flush = [&] {
        addPass(integrator, paths, threads, rendering);
        paths.clear();
        if (progress != nullptr) progress->advance(pixels);
        pixels = 0;
    };
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            for (std::int64_t index = 0; index < samples; ++index) {
                paths.push_back({{x, y}, index});
                if (paths.size() >= mostPathsAtOnce) flush();
            }
            ++pixels;
        }
    }
    flush();
    return rendering;
}

}  // namespace caustic
