#include "integrator/integrator.h"

#include <algorithm>

#include "core/parallel.h"

namespace caustic {

namespace {

constexpr std::size_t pathsPerItem = 64;  // so that threads have something to do between asking for more
constexpr std::size_t mostPathsAtOnce = std::size_t{1} << 16;  // whose contributions wait to be added to the film

// What a run of paths brings, in their order.
struct ItemResult {
    std::vector<Splat> splats;
    RayCounts counts;
};

// Traces paths and adds what they bring, in their order.
void tracePaths(const Integrator& integrator, std::span<const PathId> paths, int threads, Rendering& rendering) {
    std::vector<Color> values(paths.size());
    std::vector<ItemResult> items((paths.size() + pathsPerItem - 1) / pathsPerItem);
    parallelFor(static_cast<std::int64_t>(items.size()), threads, [&](std::int64_t item) {
        const auto first = static_cast<std::size_t>(item) * pathsPerItem;
        ItemResult& own = items[static_cast<std::size_t>(item)];
        for (std::size_t i = first; i < std::min(paths.size(), first + pathsPerItem); ++i)
            values[i] = integrator.tracePath(paths[i], own.splats, own.counts);
    });
    for (std::size_t i = 0; i < paths.size(); ++i) rendering.film.add(paths[i].pixel, paths[i].index, values[i]);
    for (const ItemResult& own : items) {
        for (const Splat& splat : own.splats) rendering.film.splat(splat.film, splat.value, integrator.filter());
        rendering.counts += own.counts;
    }
}

}  // namespace

Rendering Integrator::runPass(const Pass& pass, int threads) {
    const Camera& camera = scene_->camera();
    Rendering rendering = {Film(camera.width(), camera.height()), {}, 1, 0};
    for (std::size_t first = 0; first < pass.paths.size(); first += mostPathsAtOnce) {
        const std::size_t count = std::min(mostPathsAtOnce, pass.paths.size() - first);
        tracePaths(*this, pass.paths.subspan(first, count), threads, rendering);
    }
    rendering.film.countSplatPaths(static_cast<std::int64_t>(pass.paths.size()));
    return rendering;
}

Color Integrator::tracePath(const PathId& path, std::vector<Splat>&, RayCounts& counts) const {
    const PathNumbers numbers = sampler_->start(eyeStream, path.pixel, path.index);
    return Li(eyeRay(path, numbers, counts), scene_->cameraMedia(), numbers, counts);
}

Ray Integrator::eyeRay(const PathId& path, const PathNumbers& numbers, RayCounts& counts) const {
    const bool lens = scene_->needs().lens;
    const Vec2 centre(path.pixel.x + 0.5, path.pixel.y + 0.5);
    const Vec2 film = centre + filter_->sample(numbers.pair(Dimension::film()));
    counts.lensSamples += lens ? 1 : 0;
    return scene_->camera().sampleRay(film, lens ? numbers.pair(Dimension::lens()) : Vec2(0.5, 0.5));
}

}  // namespace caustic
