#include "integrator/integrator.h"

#include <algorithm>

#include "core/parallel.h"

namespace caustic {

namespace {

constexpr std::uint64_t eyeStream = 0;
constexpr std::int64_t pathsPerItem = 64;  // so that threads have something to do between asking for more

}  // namespace

PassBuffer Integrator::runPass(std::span<const PathId> paths, int threads) const {
    PassBuffer buffer;
    buffer.values.resize(paths.size());
    const std::int64_t count = static_cast<std::int64_t>(paths.size());
    const std::int64_t items = (count + pathsPerItem - 1) / pathsPerItem;
    std::vector<RayCounts> counts(static_cast<std::size_t>(items));
    const Camera& camera = scene_->camera();
    const bool lens = scene_->needs().lens;
    parallelFor(items, threads, [&](std::int64_t item) {
        RayCounts& own = counts[static_cast<std::size_t>(item)];
        const std::int64_t end = std::min(count, (item + 1) * pathsPerItem);
        for (std::int64_t i = item * pathsPerItem; i < end; ++i) {
            const PathId& path = paths[static_cast<std::size_t>(i)];
            const PathNumbers numbers = sampler_->start(eyeStream, path.pixel, path.index);
            const Vec2 centre(path.pixel.x + 0.5, path.pixel.y + 0.5);
            const Vec2 film = centre + filter_->sample(numbers.pair(Dimension::film()));
            own.lensSamples += lens ? 1 : 0;
            const Ray ray = camera.sampleRay(film, lens ? numbers.pair(Dimension::lens()) : Vec2(0.5, 0.5));
            buffer.values[static_cast<std::size_t>(i)] = Li(ray, scene_->cameraMedia(), numbers, own);
        }
    });
    for (const RayCounts& own : counts) buffer.counts += own;
    return buffer;
}

}  // namespace caustic
