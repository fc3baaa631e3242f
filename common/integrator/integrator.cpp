#include "integrator/integrator.h"

#include <algorithm>

#include "core/parallel.h"

namespace caustic {

namespace {

constexpr std::int64_t pathsPerItem = 64;  // so that threads have something to do between asking for more

// What a run of paths brings, in their order.
struct ItemResult {
    std::vector<Splat> splats;
    RayCounts counts;
};

}  // namespace

PassBuffer Integrator::runPass(std::span<const PathId> paths, int threads) const {
    PassBuffer buffer;
    buffer.values.resize(paths.size());
    const std::int64_t count = static_cast<std::int64_t>(paths.size());
    const std::int64_t items = (count + pathsPerItem - 1) / pathsPerItem;
    std::vector<ItemResult> results(static_cast<std::size_t>(items));
    parallelFor(items, threads, [&](std::int64_t item) {
        ItemResult& own = results[static_cast<std::size_t>(item)];
        const std::int64_t end = std::min(count, (item + 1) * pathsPerItem);
        for (std::int64_t i = item * pathsPerItem; i < end; ++i) {
            const auto at = static_cast<std::size_t>(i);
            buffer.values[at] = tracePath(paths[at], own.splats, own.counts);
        }
    });
    for (const ItemResult& own : results) {
        buffer.splats.insert(buffer.splats.end(), own.splats.begin(), own.splats.end());
        buffer.counts += own.counts;
    }
    return buffer;
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
