#include "integrator/lamp_edges.h"

#include <algorithm>
#include <string>

#include "core/check.h"
#include "core/parallel.h"
#include "integrator/render.h"
#include "integrator/visible_point.h"

namespace caustic {

namespace {

constexpr std::uint64_t edgeStream = 3;  // paths from the eye, from lights and photons have 0, 1 and 2

constexpr int side = 4;  // paths of a pixel, squared

// Whether paths through all parts of the pixel see more than one thing.
bool seesAnEdge(const Scene& scene, const Sampler& sampler, const PathLimits& limits, Pixel pixel) {
    RayCounts counts;
    Color first = Color::Zero();
    for (int i = 0; i < side * side; ++i) {
        const PathNumbers numbers = sampler.start(edgeStream, pixel, i);
        const Vec2 u = numbers.pair(Dimension::film());
        const Vec2 film(pixel.x + (i % side + u.x()) / side, pixel.y + (i / side + u.y()) / side);
        const Ray ray = scene.camera().sampleRay(film, numbers.pair(Dimension::lens()));
        const Color seen = findVisiblePoint(scene, ray, scene.cameraMedia(), limits, numbers, counts).seen;
        if (i == 0) first = seen;
        if ((seen != first).any()) return true;
    }
    return false;
}

}  // namespace

std::vector<Pixel> lampEdges(const Scene& scene, const Sampler& sampler, const PathLimits& limits, int threads) {
    const int width = scene.camera().width();
    const int height = scene.camera().height();
    std::vector<std::vector<int>> found(static_cast<std::size_t>(height));  // columns by row
    parallelFor(height, threads, [&](std::int64_t y) {
        for (int x = 0; x < width; ++x) {
            if (seesAnEdge(scene, sampler, limits, {x, static_cast<int>(y)}))
                found[static_cast<std::size_t>(y)].push_back(x);
        }
    });
    std::vector<bool> edge(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), false);
    const auto at = [width](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < height; ++y) {
        for (const int x : found[static_cast<std::size_t>(y)]) {
            for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j) {
                for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) edge[at(i, j)] = true;
            }
        }
    }
    std::vector<Pixel> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (edge[at(x, y)]) pixels.push_back({x, y});
        }
    }
    return pixels;
}

std::function<std::vector<PathId>(const Rendering& soFar)> withMorePaths(const Camera& camera,
                                                                         const std::vector<Pixel>& several, int paths) {
    checkArgument(paths >= 1, "paths of a pixel in a pass", std::to_string(paths), "must be at least 1");
    // Those of the first pass; a pixel's paths are numbered on from pass to pass.
    std::vector<PathId> all = pathsOfAllPixels(camera, 0);
    return [all, several, paths, width = camera.width()](const Rendering& soFar) {
        std::vector<PathId> chosen = all;
        for (PathId& path : chosen) path.index = soFar.passes;
        for (const Pixel& pixel : several) {
            const std::int64_t first = soFar.passes * paths;
            chosen[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(pixel.x)]
                .index = first;
            for (int i = 1; i < paths; ++i) chosen.push_back({pixel, first + i});
        }
        return chosen;
    };
}

}  // namespace caustic
